#include "io/volume/open_stored_volume.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/volume/nifti.h"
#include "io/volume/nrrd.h"
#include "io/volume/plain_volume.h"
#include "io/volume/voxel_stream.h"

namespace angiopose::io {
namespace {

/// Returns the first bytes of a file, decompressed if necessary.
std::string unpackedHead(std::string_view content, const std::string& path)
{
    return content.starts_with("\x1f\x8b") ? decompressedStart(path, niftiHeadSize)
                                           : std::string(content.substr(0, niftiHeadSize));
}

bool isNrrd(std::string_view content)
{
    return content.starts_with("NRRD000");
}

}   // namespace

bool isStoredVolume(const std::string& path)
{
    const auto input = openInputStart(path);
    if (!input) {
        return false;
    }
    const std::string_view content = input.value().view();
    return isNrrd(content) || looksLikeNifti(unpackedHead(content, path)) || plainFormatOf(content, path).has_value();
}

core::Result<StoredVolume> openStoredVolume(const std::string& path)
{
    const auto input = openInputStart(path);
    if (!input) {
        return input.error();
    }
    const std::string_view content = input.value().view();
    if (isNrrd(content)) {
        return parseNrrd(content, path);
    }
    if (const std::string head = unpackedHead(content, path); looksLikeNifti(head)) {
        return parseNifti(head, path);
    }
    if (const auto format = plainFormatOf(content, path)) {
        return openPlainVolume(*format, content, path);
    }
    const auto* found = describeContent(content);
    return fileError(path, found ? messages::volumeIsOther((*found)()) : messages::volumeUnknown());
}

}   // namespace angiopose::io
