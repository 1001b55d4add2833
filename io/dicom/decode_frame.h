#pragma once

#include "io/dicom/pixel_layout.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// The result of decoding a compressed frame.
struct DecodedPixels {
    std::vector<char> bytes;   ///< in the native form of the layout, little endian
    bool isFlawed = false;   ///< partly damaged; contains the part that could be decoded
};

/// Decodes one compressed frame (JPEG, JPEG-LS, JPEG 2000, RLE). Corrects `layout` if the compressed stream contradicts
/// it. Returns nothing on failure; lossy JPEG must be more than half intact, the others complete.
std::optional<DecodedPixels> decodeFrame(std::string_view compressed, const std::string& transferSyntax,
                                         PixelLayout& layout);

/// The image properties declared by a JPEG, JPEG-LS or JPEG 2000 stream; nothing if its header is unreadable.
struct StreamHead {
    int columns = 0;
    int rows = 0;
    int components = 0;
    int bits = 0;   ///< per sample
    bool isBaseline = false;   ///< 8-bit lossy JPEG
};
std::optional<StreamHead> streamHeadOf(std::string_view stream);

}   // namespace angiopose::io