#include "io/dicom/decode_rle.h"

#include <algorithm>

namespace angiopose::io {
namespace {

constexpr std::size_t headerSize = 64;
constexpr std::size_t maxSegments = 15;

/// Unpacks PackBits into every `stride`-th byte from `out`; false when `count` bytes do not come out.
bool unpack(std::string_view segment, char* out, std::size_t count, std::size_t stride)
{
    std::size_t done = 0;
    for (std::size_t at = 0; at < segment.size() && done < count;) {
        const int byte = static_cast<unsigned char>(segment[at++]);
        const int control = byte < 128 ? byte : byte - 256;
        if (control == -128) {
            continue;
        }
        const auto length = static_cast<std::size_t>(control >= 0 ? control + 1 : 1 - control);
        const std::size_t taken = control >= 0 ? length : 1;
        if (taken > segment.size() - at) {
            return false;
        }
        for (std::size_t i = 0; i < length && done < count; ++i, ++done) {
            out[done * stride] = segment[control >= 0 ? at + i : at];
        }
        at += taken;
    }
    return done == count;
}

}   // namespace

std::optional<std::vector<char>> decodeRle(std::string_view compressed, const PixelLayout& layout)
{
    const auto sampleBytes = static_cast<std::size_t>(layout.bitsAllocated / 8);
    const auto samples = static_cast<std::size_t>(layout.samples);
    const std::size_t planes = sampleBytes * samples;   // one segment per byte of a pixel
    constexpr DicomEncoding little{true, false};
    if (compressed.size() < headerSize || planes == 0 || planes > maxSegments ||
        readUint32(compressed, little) != planes) {
        return std::nullopt;
    }
    std::vector<char> bytes(layout.pixelsPerFrame() * planes);
    for (std::size_t plane = 0; plane < planes; ++plane) {
        const std::size_t first = readUint32(compressed.substr(4 + 4 * plane), little);
        const std::size_t end =
            plane + 1 < planes ? readUint32(compressed.substr(8 + 4 * plane), little) : compressed.size();
        if (first < headerSize || end < first || end > compressed.size()) {
            return std::nullopt;
        }
        // Segments go from the most significant byte down.
        const std::size_t sample = plane / sampleBytes;
        const std::size_t byte = sampleBytes - 1 - plane % sampleBytes;
        char* out = bytes.data() + sample * sampleBytes + byte;
        if (!unpack(compressed.substr(first, end - first), out, layout.pixelsPerFrame(), planes)) {
            return std::nullopt;
        }
    }
    return bytes;
}

}   // namespace angiopose::io