#include "io/support/input_bytes.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/system/files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <utility>

namespace angiopose::io {
namespace {

/// Returns why the path is not a readable file, if so. Called before opening, since opening a pipe would block forever.
std::optional<core::Message> findObstacle(const std::string& path)
{
    const FileStatus facts = fileStatus(path);
    switch (facts.kind) {
        case FileKind::Missing:
            return messages::fileMissing();
        case FileKind::Unreachable:
            return messages::fileUnreachable(facts.problem);
        case FileKind::Folder:
            return messages::fileIsFolder();
        case FileKind::Other:
            return messages::fileNotRegular();
        case FileKind::Regular:
            break;
    }
    return facts.size == 0 ? std::optional(messages::fileEmpty()) : std::nullopt;
}

core::Result<InputBytes> openFirst(const std::string& path, std::size_t wanted)
{
    if (const auto obstacle = findObstacle(path)) {
        return fileError(path, *obstacle);
    }
    ReadHandle file(path);
    if (!file.isOpen()) {
        return fileError(path, messages::fileNotOpened(file.problem()));
    }
    const std::size_t size = file.size();
    const char* const mapping = file.map();
    if (!mapping) {
        return fileError(path, messages::fileNotRead(file.problem()));
    }
    InputBytes content(mapping, size);
    if (const auto problem = findReadError(content.view().data(), std::min(size, wanted))) {
        return fileError(path, *problem);
    }
    if (content.view().starts_with("version https://git-lfs.github.com/spec/")) {
        return fileError(path, messages::fileIsLfsPointer());
    }
    return content;
}

struct Signature {
    std::size_t offset;
    std::string_view bytes;
    const core::MessageKind<0>* meaning;
};

constexpr std::array signatures = {
    Signature{0, "\x1f\x8b", &messages::aGzipArchive},
    Signature{0, "PK\x03\x04", &messages::aZipArchive},
    Signature{0, "NRRD000", &messages::anNrrdVolume},
    Signature{344, "n+1", &messages::aNiftiVolume},
    Signature{344, "ni1", &messages::aNiftiHeader},
    Signature{0, "\x89HDF", &messages::anHdf5File},
    Signature{0, "CDF\x01", &messages::aNetCdfVolume},
    Signature{0, "ObjectType", &messages::aMetaImageHeader},
    Signature{0, "TRACK", &messages::aTrackVisTractogram},
    Signature{0, "mrtrix tracks", &messages::anMrtrixTractogram},
    Signature{0, "ply", &messages::aPlySurface},
    Signature{0, "solid", &messages::anStlSurface},
    Signature{0, "glTF", &messages::aGltfScene},
    Signature{0, "%PDF", &messages::aPdfDocument},
    Signature{128, "DICM", &messages::aDicomFile},
    Signature{0, "\x89PNG", &messages::aPngImage},
    Signature{0, "\xff\xd8\xff", &messages::aJpegImage},
    Signature{0, {"II*\0", 4}, &messages::aTiffImage},
    Signature{0, {"MM\0*", 4}, &messages::aTiffImage},
    Signature{0, "# vtk DataFile", &messages::aLegacyVtkFile},
    Signature{0, "<?xml", &messages::anXmlFile},
    Signature{0, "<VTKFile", &messages::aVtkXmlFile},
    Signature{0, "{", &messages::aJsonFile},
};

}   // namespace

std::optional<core::Message> findReadError(const char* mapping, std::size_t size)
{
    const auto fault = findMappingFault(mapping, size);
    return fault ? std::optional<core::Message>(messages::fileNotRead(*fault)) : std::nullopt;
}

InputBytes::InputBytes(InputBytes&& other) noexcept
    : mapping_(std::exchange(other.mapping_, nullptr)),
      size_(std::exchange(other.size_, 0)),
      owned_(std::move(other.owned_))
{
}

InputBytes& InputBytes::operator=(InputBytes&& other) noexcept
{
    std::swap(mapping_, other.mapping_);
    std::swap(size_, other.size_);
    std::swap(owned_, other.owned_);
    return *this;
}

InputBytes::~InputBytes()
{
    if (mapping_) {
        unmap(mapping_, size_);
    }
}

core::Result<InputBytes> openInput(const std::string& path)
{
    return openFirst(path, std::numeric_limits<std::size_t>::max());
}

core::Result<InputBytes> openInputStart(const std::string& path)
{
    return openFirst(path, startBytes);
}

bool isFolder(const std::string& path)
{
    std::error_code unknown;
    return std::filesystem::is_directory(path, unknown);
}

std::string extensionOf(const std::string& path)
{
    const std::filesystem::path file(path);
    std::string extension = file.extension().string();
    if (extension == ".gz") {
        extension = file.stem().extension().string() + extension;
    }
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
    return extension;
}

const core::MessageKind<0>* describeContent(std::string_view content)
{
    for (const Signature& signature : signatures) {
        if (content.size() > signature.offset && content.substr(signature.offset).starts_with(signature.bytes)) {
            return signature.meaning;
        }
    }
    return nullptr;
}

}   // namespace angiopose::io
