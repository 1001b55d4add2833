#pragma once

#include "io/dicom/pixel_layout.h"

#include <optional>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Decodes a JPEG 2000 stream through OpenJPEG to little-endian samples, interleaved by pixel; returns nullopt if it is
/// damaged, truncated or differs from the layout. DCMTK lacks such a decoder; that of GDCM aborts on damaged streams.
std::optional<std::vector<char>> decodeJpeg2000(std::string_view compressed, const PixelLayout& layout);

}   // namespace angiopose::io
