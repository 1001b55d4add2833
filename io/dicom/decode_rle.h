#pragma once

#include "io/dicom/pixel_layout.h"

#include <optional>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// One RLE frame (PS3.5 annex G) as interleaved little-endian samples; nothing when a segment is damaged or short.
std::optional<std::vector<char>> decodeRle(std::string_view compressed, const PixelLayout& layout);

}   // namespace angiopose::io