#pragma once

#include "io/dicom/pixel_layout.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// What became of a compressed frame.
struct DecodedPixels {
    std::vector<char> bytes;   ///< in the layout's native form, little endian
    bool isFlawed = false;   ///< damaged in part: what could be decoded is there
};

/// Decodes one compressed frame (JPEG, JPEG-LS, JPEG 2000, RLE). `layout` is adjusted where the compressed stream knows
/// better. Nothing when it cannot be decoded: lossy JPEG in more than a half, the others whole.
std::optional<DecodedPixels> decodeFrame(std::string_view compressed, const std::string& transferSyntax,
                                         PixelLayout& layout);

/// What a JPEG, JPEG-LS or JPEG 2000 stream declares; nothing when it has no readable header.
struct StreamHead {
    int columns = 0;
    int rows = 0;
    int components = 0;
    int bits = 0;   ///< per sample
    bool isBaseline = false;   ///< 8-bit lossy JPEG
};
std::optional<StreamHead> streamHeadOf(std::string_view stream);

}   // namespace angiopose::io