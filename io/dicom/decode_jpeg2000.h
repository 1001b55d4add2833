#pragma once

#include "io/dicom/pixel_layout.h"

#include <optional>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Decodes a JPEG 2000 stream through OpenJPEG to samples, colors by pixel, little endian; returns nothing if it is
/// damaged, truncated or differs from the layout. DCMTK has no decoder for it, and GDCM's asserts on damaged streams.
std::optional<std::vector<char>> decodeJpeg2000(std::string_view compressed, const PixelLayout& layout);

}   // namespace angiopose::io
