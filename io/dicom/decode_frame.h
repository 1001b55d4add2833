#pragma once

#include "io/dicom/pixel_layout.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Result of decoding a compressed frame.
struct DecodedPixels {
    std::vector<char> bytes;   ///< pixels in the native form of the layout, little endian
    bool isPartlyDamaged = false;   ///< true if damaged in part; `bytes` then contains what could be decoded
};

/// Decodes one compressed frame (JPEG, JPEG-LS, JPEG 2000, RLE). Corrects `layout` if the compressed stream contradicts
/// it. Returns nullopt on failure. More than half of a lossy JPEG must be intact; other streams must be complete.
std::optional<DecodedPixels> decodeFrame(std::string_view compressed, const std::string& transferSyntax,
                                         PixelLayout& layout);

/// Image properties declared by a JPEG, JPEG-LS or JPEG 2000 stream.
struct StreamHeader {
    int columns = 0;
    int rows = 0;
    int components = 0;
    int bits = 0;   ///< bits per sample
    bool isBaseline = false;   ///< whether the stream is 8-bit lossy JPEG
};
std::optional<StreamHeader> readStreamHeader(std::string_view stream);

}   // namespace angiopose::io
