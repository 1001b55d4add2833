#pragma once

#include "io/dicom/pixel_layout.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Raw bytes of one compressed frame (JPEG, JPEG-LS, JPEG 2000, RLE) in the layout's native form, little endian.
/// `layout` is adjusted where the compressed stream knows better. Nothing when it cannot be decoded whole.
std::optional<std::vector<char>> decodeFrame(std::string_view compressed, const std::string& transferSyntax,
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