#pragma once

#include "io/dicom/pixel_layout.h"

#include <optional>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Samples of a JPEG 2000 stream by OpenJPEG, colours by pixel, little endian; nothing when it is damaged, cut short or
/// not of the layout. DCMTK has no decoder for it, and GDCM's asserts on damaged streams.
std::optional<std::vector<char>> decodeJpeg2000(std::string_view compressed, const PixelLayout& layout);

}   // namespace angiopose::io
