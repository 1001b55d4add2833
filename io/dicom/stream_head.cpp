#include "io/dicom/decode_frame.h"

#include "io/support/byte_order.h"

namespace angiopose::io {
namespace {

constexpr std::string_view codestreamStart("\xff\x4f\xff\x51", 4);   // markers SOC and SIZ (ISO 15444-1)

std::optional<StreamHeader> jpeg2000Head(std::string_view stream)
{
    const std::size_t start = stream.substr(0, 4096).find(codestreamStart);   // after the boxes of a JP2 file
    if (start == std::string_view::npos || stream.size() < start + 43) {
        return std::nullopt;
    }
    const auto at = [&](std::size_t offset) { return readUint32(stream.substr(start + offset), ByteOrder::Big); };
    const std::uint32_t columns = at(8) - at(16);
    const std::uint32_t rows = at(12) - at(20);
    const int components = readUint16(stream.substr(start + 40), ByteOrder::Big);
    const int bits = (static_cast<unsigned char>(stream[start + 42]) & 0x7f) + 1;
    return StreamHeader{static_cast<int>(columns), static_cast<int>(rows), components, bits, false};
}

/// Returns whether a marker starts a frame: SOF0…SOF15 except DHT, JPG and DAC, and SOF55 of JPEG-LS.
bool isFrameStart(unsigned char marker)
{
    const bool isSof = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    return isSof || marker == 0xf7;
}

}   // namespace

std::optional<StreamHeader> readStreamHeader(std::string_view stream)
{
    if (!stream.starts_with("\xff\xd8")) {
        return jpeg2000Head(stream);
    }
    for (std::size_t at = 2; at + 10 <= stream.size();) {
        if (static_cast<unsigned char>(stream[at]) != 0xff) {
            return std::nullopt;
        }
        const auto marker = static_cast<unsigned char>(stream[at + 1]);
        if (marker == 0xff) {   // skip a fill byte
            ++at;
            continue;
        }
        if (isFrameStart(marker)) {
            return StreamHeader{readUint16(stream.substr(at + 7), ByteOrder::Big),
                                readUint16(stream.substr(at + 5), ByteOrder::Big),
                                static_cast<unsigned char>(stream[at + 9]), static_cast<unsigned char>(stream[at + 4]),
                                marker <= 0xc2 && stream[at + 4] == 8};
        }
        at += 2 + std::size_t{readUint16(stream.substr(at + 2), ByteOrder::Big)};
    }
    return std::nullopt;
}

}   // namespace angiopose::io
