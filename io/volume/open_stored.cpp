#include "io/volume/open_stored.h"

#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/volume/byte_stream.h"
#include "io/volume/meta_image.h"
#include "io/volume/nifti.h"
#include "io/volume/nrrd.h"

namespace angiopose::io {
namespace {

/// The first bytes of a file, unpacked where it is packed.
struct FileHead {
    std::string bytes;
    StreamPacking packing = StreamPacking::None;
};

FileHead headOf(std::string_view content, const std::string& path)
{
    FileHead head{std::string(content.substr(0, niftiHeadSize)), StreamPacking::None};
    if (!content.starts_with("\x1f\x8b")) {
        return head;
    }
    head.packing = StreamPacking::Deflate;
    head.bytes.clear();
    if (auto opened = ByteStream::open({path, 0, StreamPacking::Deflate})) {
        ByteStream stream = std::move(opened).value();
        head.bytes.resize(niftiHeadSize);
        head.bytes.resize(stream.readSome(head.bytes.data(), niftiHeadSize));
    }
    return head;
}

bool looksLikeMetaImage(std::string_view head, const std::string& path)
{
    const std::string extension = extensionOf(path);
    return head.starts_with("ObjectType") || head.find("ElementDataFile") != std::string_view::npos ||
           ((extension == ".mhd" || extension == ".mha") && head.find("NDims") != std::string_view::npos);
}

std::optional<VolumeFormat> formatOf(const FileHead& head, const std::string& path)
{
    if (head.packing == StreamPacking::None && head.bytes.starts_with("NRRD000")) {
        return VolumeFormat::Nrrd;
    }
    if (looksLikeNifti(head.bytes)) {
        return VolumeFormat::Nifti;
    }
    if (head.packing == StreamPacking::None && looksLikeMetaImage(head.bytes, path)) {
        return VolumeFormat::MetaImage;
    }
    return std::nullopt;
}

}   // namespace

std::optional<VolumeFormat> volumeFormatOf(const std::string& path)
{
    const auto input = openInput(path);
    return input ? formatOf(headOf(input.value().view(), path), path) : std::nullopt;
}

core::Result<StoredVolume> openStored(const std::string& path)
{
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    const std::string_view content = input.value().view();
    const FileHead head = headOf(content, path);
    const auto format = formatOf(head, path);
    if (!format) {
        const auto* found = describeContent(content);
        if (found == nullptr) {
            return fileError(path, says::volumeUnknown());
        }
        return fileError(path, says::volumeIsOther((*found)()));
    }
    switch (*format) {
        case VolumeFormat::Nifti:
            return parseNifti(head.bytes, head.packing, path);
        case VolumeFormat::Nrrd:
            return parseNrrd(content, path);
        default:
            return parseMetaImage(content, path);
    }
}

}   // namespace angiopose::io