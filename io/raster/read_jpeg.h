#pragma once

#include "io/raster/read_raster.h"

#include <optional>
#include <string_view>

namespace angiopose::io {

/// Interpretation of the three color channels of a JPEG.
enum class JpegColors {
    FromMarkers,   ///< as specified by the markers of the stream, by default Y Cb Cr
    RgbUnlessMarked   ///< red, green, blue unless a marker specifies otherwise; for DICOM headers with "RGB"
};

/// Decodes a gray or color JPEG; returns nullopt if it is too large or of another kind, or if less than half of its
/// rows can be decoded. Sets `isPartlyDamaged` if the decoder reports damage: parts may be wrong; missing rows have the
/// mean gray level.
std::optional<Raster> readJpeg(std::string_view content, JpegColors colors = JpegColors::FromMarkers);

}   // namespace angiopose::io
