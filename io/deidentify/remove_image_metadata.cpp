#include "io/deidentify/remove_image_metadata.h"

#include "io/deidentify/remove_tiff_metadata.h"
#include "io/messages/messages.h"
#include "io/raster/image_orientation.h"
#include "io/support/byte_order.h"
#include "io/support/file_error.h"

#include <zlib.h>
#include <algorithm>
#include <array>
#include <optional>

namespace angiopose::io {
namespace {

constexpr std::string_view pngStart = "\x89PNG\r\n\x1a\n";
constexpr std::array<std::string_view, 7> keptChunks{"IHDR", "PLTE", "tRNS", "gAMA", "pHYs", "IDAT", "IEND"};

std::string bigEndian(std::size_t value)
{
    return {static_cast<char>(value >> 24U), static_cast<char>(value >> 16U), static_cast<char>(value >> 8U),
            static_cast<char>(value)};
}

/// Returns an EXIF chunk with the orientation, without which the image would be displayed rotated or mirrored.
std::string orientationChunk(int orientation)
{
    const std::string chunk = "eXIf" + makeExif(orientation);
    const uLong sum = crc32_z(0, reinterpret_cast<const Bytef*>(chunk.data()), chunk.size());
    return bigEndian(chunk.size() - 4) + chunk + bigEndian(sum);
}

/// Copies only the required chunks of a PNG: length, name, content, checksum (ISO/IEC 15948, 5.3).
std::optional<std::string> removePngMetadata(std::string_view rest)
{
    const int orientation = exifOrientation(rest);
    std::string kept(pngStart);
    rest.remove_prefix(pngStart.size());
    while (rest.size() >= 12) {
        const std::size_t length = readUint32(rest, ByteOrder::Big);
        if (length > rest.size() - 12) {
            return std::nullopt;
        }
        const std::string_view name = rest.substr(4, 4);
        if (std::ranges::find(keptChunks, name) != keptChunks.end()) {
            kept += rest.substr(0, length + 12);
        }
        if (name == "IHDR" && orientation > 1) {
            kept += orientationChunk(orientation);
        }
        if (name == "IEND") {
            return kept;
        }
        rest.remove_prefix(length + 12);
    }
    return std::nullopt;
}

constexpr unsigned char startOfScan = 0xda;
constexpr unsigned char endOfImage = 0xd9;
constexpr unsigned char jfif = 0xe0;
constexpr unsigned char adobe = 0xee;
constexpr unsigned char comment = 0xfe;
constexpr std::size_t jfifBytes = 18;   ///< size of the JFIF segment including its marker, without a thumbnail

bool isApplication(unsigned char marker)
{
    return (marker & 0xf0U) == 0xe0;
}

/// Returns the end of the coded data of a scan: the next marker that is neither a stuffed byte nor a restart marker.
std::size_t endOfScan(std::string_view bytes)
{
    for (std::size_t at = 0; at + 1 < bytes.size(); ++at) {
        const auto next = static_cast<unsigned char>(bytes[at + 1]);
        if (static_cast<unsigned char>(bytes[at]) == 0xff && next != 0 && next != 0xff &&
            (next < 0xd0 || next > 0xd7)) {
            return at;
        }
    }
    return bytes.size();
}

/// Returns a JFIF segment with the print resolution but without the thumbnail that may follow.
std::string removeThumbnail(std::string_view segment)
{
    std::string kept(segment.substr(0, jfifBytes));
    kept[2] = 0;
    kept[3] = jfifBytes - 2;
    kept[jfifBytes - 2] = kept[jfifBytes - 1] = 0;
    return kept;
}

/// Copies only the required segments of a JPEG: marker, length, content (ITU-T T.81, annex B).
std::optional<std::string> removeJpegMetadata(std::string_view rest)
{
    std::string kept("\xff\xd8");
    if (const int orientation = exifOrientation(rest); orientation > 1) {
        const std::string exif = std::string("Exif\0\0", 6) + makeExif(orientation);
        kept += std::string("\xff\xe1\0", 3) + static_cast<char>(exif.size() + 2) + exif;
    }
    rest.remove_prefix(2);
    while (rest.size() >= 4 && static_cast<unsigned char>(rest[0]) == 0xff) {
        const auto marker = static_cast<unsigned char>(rest[1]);
        if (marker == 0xff) {   // skip a fill byte
            rest.remove_prefix(1);
            continue;
        }
        const std::size_t size = 2 + std::size_t{readUint16(rest.substr(2), ByteOrder::Big)};
        if (size > rest.size()) {
            return std::nullopt;
        }
        const std::string_view segment = rest.substr(0, size);
        if (marker == jfif && size >= jfifBytes && segment.substr(4, 4) == "JFIF") {
            kept += removeThumbnail(segment);
        } else if (marker == adobe && segment.substr(4, 5) == "Adobe") {
            kept += segment;
        } else if (!isApplication(marker) && marker != comment) {
            kept += segment;
        }
        rest.remove_prefix(size);
        if (marker == startOfScan) {
            const std::size_t end = endOfScan(rest);
            kept += rest.substr(0, end);
            rest.remove_prefix(end);
        }
        if (rest.size() >= 2 && static_cast<unsigned char>(rest[1]) == endOfImage) {
            return kept + "\xff\xd9";
        }
    }
    return std::nullopt;
}

}   // namespace

core::Result<std::string> removeImageMetadata(std::string_view picture, const std::string& path)
{
    if (looksLikeTiff(picture)) {
        return removeTiffMetadata(picture, path);
    }
    const bool isPng = picture.starts_with(pngStart);
    if (!isPng && !picture.starts_with("\xff\xd8")) {
        return fileError(path, messages::pictureNotStripped());
    }
    auto stripped = isPng ? removePngMetadata(picture) : removeJpegMetadata(picture);
    return stripped ? core::Result<std::string>(std::move(*stripped)) : fileError(path, messages::imageDamaged());
}

}   // namespace angiopose::io
