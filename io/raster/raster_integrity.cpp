#include "io/raster/raster_integrity.h"

#include "io/messages/says.h"
#include "io/support/byte_order.h"

#include <zlib.h>
#include <utility>

namespace angiopose::io {
namespace {

constexpr std::string_view pngSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t maxPngSide = 1'000'000;   // libpng takes no more
constexpr std::size_t maxJpegTrailer = 4096;

/// The fields of the header chunk (PNG §11.2.2): libpng leaves the process over one that cannot be.
bool isSoundHeader(std::string_view header)
{
    if (header.size() != 13) {
        return false;
    }
    const std::size_t width = readUint32(header, ByteOrder::Big), height = readUint32(header.substr(4), ByteOrder::Big);
    const int depth = header[8], colour = header[9];
    const bool isGrey = colour == 0 && (depth == 1 || depth == 2 || depth == 4 || depth == 8 || depth == 16);
    const bool isPalette = colour == 3 && (depth == 1 || depth == 2 || depth == 4 || depth == 8);
    const bool isOther = (colour == 2 || colour == 4 || colour == 6) && (depth == 8 || depth == 16);
    return width > 0 && height > 0 && width <= maxPngSide && height <= maxPngSide && (isGrey || isPalette || isOther) &&
           header[10] == 0 && header[11] == 0 && (header[12] == 0 || header[12] == 1);
}

/// What libpng would leave the process over, beside the header: critical chunks that it does not know, or palettes that
/// are missing, empty or in the wrong place.
class ChunkOrder {
public:
    bool accepts(std::string_view type, std::string_view data)
    {
        const bool isFirst = std::exchange(isAtStart_, false);
        if (isFirst || type == "IHDR") {
            needsPalette_ = data.size() > 9 && data[9] == 3;
            return isFirst && type == "IHDR" && isSoundHeader(data);
        }
        if (type == "PLTE") {
            const bool isSound =
                !hasPalette_ && !hasData_ && !data.empty() && data.size() <= 768 && data.size() % 3 == 0;
            hasPalette_ = true;
            return isSound;
        }
        hasData_ |= type == "IDAT";
        if (type == "IDAT" || type == "IEND") {
            return hasData_ && (hasPalette_ || !needsPalette_);
        }
        return type.front() >= 'a';   // ancillary: libpng warns and goes on
    }

private:
    bool isAtStart_ = true, needsPalette_ = false, hasPalette_ = false, hasData_ = false;
};

/// Walks the chunks and their checksums (PNG §5.3).
bool isWholePng(std::string_view content)
{
    ChunkOrder order;
    std::size_t at = pngSignature.size();
    while (at + 12 <= content.size()) {
        const std::size_t length = readUint32(content.substr(at), ByteOrder::Big);
        if (length > content.size() - at - 12) {
            return false;
        }
        const std::string_view typeAndData = content.substr(at + 4, length + 4);
        const uLong sum = crc32_z(0, reinterpret_cast<const Bytef*>(typeAndData.data()), length + 4);
        if (sum != readUint32(content.substr(at + 8 + length), ByteOrder::Big) ||
            !order.accepts(typeAndData.substr(0, 4), typeAndData.substr(4))) {
            return false;
        }
        if (typeAndData.starts_with("IEND")) {
            return true;
        }
        at += length + 12;
    }
    return false;
}

bool isWholeJpeg(std::string_view content)
{
    const std::size_t end = content.rfind("\xff\xd9");
    return end != std::string_view::npos && end + maxJpegTrailer >= content.size();
}

}   // namespace

std::optional<core::Message> findRasterDamage(std::string_view content)
{
    const bool isPng = content.starts_with("\x89PNG");
    if ((isPng && !(content.starts_with(pngSignature) && isWholePng(content))) ||
        (content.starts_with("\xff\xd8") && !isWholeJpeg(content))) {
        return says::imageDamaged();
    }
    return {};
}

}   // namespace angiopose::io