#include "io/raster/image_orientation.h"

#include "io/support/byte_order.h"

#include <algorithm>
#include <optional>

namespace angiopose::io {
namespace {

constexpr std::string_view pngSignature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view exifStart("Exif\0\0", 6);
constexpr std::uint16_t orientationTag = 274;
constexpr std::uint16_t longType = 4;   // nonstandard type; the specification requires SHORT

/// Reads the orientation from the first directory of EXIF data, which start with a TIFF header.
std::optional<int> orientationIn(std::string_view exif)
{
    if (exif.size() < 8 || (exif[0] != 'I' && exif[0] != 'M')) {
        return std::nullopt;
    }
    const ByteOrder order = exif[0] == 'I' ? ByteOrder::Little : ByteOrder::Big;
    const std::size_t directory = readUint32(exif.substr(4), order);
    if (directory + 2 > exif.size()) {
        return std::nullopt;
    }
    const std::size_t count = readUint16(exif.substr(directory), order);
    for (std::size_t at = directory + 2, i = 0; i < count && at + 12 <= exif.size(); at += 12, ++i) {
        if (readUint16(exif.substr(at), order) == orientationTag) {
            const std::string_view value = exif.substr(at + 8);
            const bool isLong = readUint16(exif.substr(at + 2), order) == longType;
            const std::uint32_t stated = isLong ? readUint32(value, order) : readUint16(value, order);
            return stated >= 1 && stated <= 8 ? std::optional(static_cast<int>(stated)) : std::nullopt;
        }
    }
    return std::nullopt;
}

/// Searches the chunks of a PNG (length, name, content, checksum) for the orientation.
std::optional<int> orientationOfPng(std::string_view rest)
{
    rest.remove_prefix(pngSignature.size());
    while (rest.size() >= 12) {
        const std::size_t length = std::min<std::size_t>(readUint32(rest, ByteOrder::Big), rest.size() - 12);
        if (rest.substr(4, 4) == "eXIf") {
            const std::string_view exif = rest.substr(8, length);
            return orientationIn(exif.starts_with(exifStart) ? exif.substr(exifStart.size()) : exif);
        }
        rest.remove_prefix(length + 12);
    }
    return std::nullopt;
}

/// Searches the segments of a JPEG (marker, length, content) before the pixels for the orientation.
std::optional<int> orientationOfJpeg(std::string_view rest)
{
    rest.remove_prefix(2);
    while (rest.size() >= 4 && rest[0] == '\xff' && rest[1] != '\xda') {
        if (rest[1] == '\xff') {   // skip a fill byte
            rest.remove_prefix(1);
            continue;
        }
        const std::size_t size = std::min(2 + std::size_t{readUint16(rest.substr(2), ByteOrder::Big)}, rest.size());
        const std::string_view content = rest.substr(4, std::max<std::size_t>(size, 4) - 4);
        if (rest[1] == '\xe1' && content.starts_with(exifStart)) {
            return orientationIn(content.substr(exifStart.size()));
        }
        rest.remove_prefix(size);
    }
    return std::nullopt;
}

}   // namespace

int exifOrientation(std::string_view picture)
{
    const auto stated = picture.starts_with(pngSignature) ? orientationOfPng(picture)
                        : picture.starts_with("\xff\xd8") ? orientationOfJpeg(picture)
                                                          : std::nullopt;
    return stated.value_or(1);
}

std::string makeExif(int orientation)
{
    std::string exif("MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\0\0\0\0\0\0\0", 26);
    exif[19] = static_cast<char>(orientation);
    return exif;
}

core::ImageF applyOrientation(const core::ImageF& stored, int orientation)
{
    const bool isTransposed = orientation >= 5;
    const bool turnsColumns = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool turnsRows = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    core::ImageF shown(isTransposed ? stored.height : stored.width, isTransposed ? stored.width : stored.height);
    for (int y = 0; y < shown.height; ++y) {
        for (int x = 0; x < shown.width; ++x) {
            const int column = isTransposed ? y : x, row = isTransposed ? x : y;
            shown.at(x, y) =
                stored.at(turnsColumns ? stored.width - 1 - column : column, turnsRows ? stored.height - 1 - row : row);
        }
    }
    return shown;
}

}   // namespace angiopose::io
