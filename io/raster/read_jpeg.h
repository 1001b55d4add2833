#pragma once

#include "io/raster/read_raster.h"

#include <optional>
#include <string_view>

namespace angiopose::io {

/// Interpretation of the three channels of a JPEG.
enum class JpegColors {
    AsMarked,   ///< as the markers of the stream state, otherwise Y Cb Cr
    RgbUnlessMarked   ///< for DICOM headers with "RGB": red, green and blue unless a marker states otherwise
};

/// Decodes a gray or color JPEG; nullopt if it is too large, of another kind, or less than half of its rows can be
/// decoded. `isFlawed` reports that the decoder complained: parts may be wrong, and missing rows have the frame's mean.
std::optional<Raster> readJpeg(std::string_view content, JpegColors colors = JpegColors::AsMarked);

}   // namespace angiopose::io