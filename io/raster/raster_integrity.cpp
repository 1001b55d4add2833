#include "io/raster/raster_integrity.h"

#include "io/dicom/dicom_dataset.h"
#include "io/messages/says.h"

#include <zlib.h>

namespace angiopose::io {
namespace {

constexpr std::string_view pngSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t maxJpegTrailer = 4096;
constexpr DicomEncoding bigEndian{true, true};

/// Walks the chunks and their checksums (PNG §5.3).
bool isWholePng(std::string_view content)
{
    std::size_t at = pngSignature.size();
    while (at + 12 <= content.size()) {
        const std::size_t length = readUint32(content.substr(at), bigEndian);
        if (length > content.size() - at - 12) {
            return false;
        }
        const std::string_view typeAndData = content.substr(at + 4, length + 4);
        const uLong sum = crc32(0, reinterpret_cast<const Bytef*>(typeAndData.data()), static_cast<uInt>(length + 4));
        if (sum != readUint32(content.substr(at + 8 + length), bigEndian)) {
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
    const bool isPng = content.starts_with(pngSignature);
    if ((isPng && !isWholePng(content)) || (content.starts_with("\xff\xd8") && !isWholeJpeg(content))) {
        return says::imageDamaged();
    }
    return {};
}

}   // namespace angiopose::io