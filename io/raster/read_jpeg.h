#pragma once

#include "io/raster/read_raster.h"

#include <optional>
#include <string_view>

namespace angiopose::io {

/// What the three channels of a JPEG are.
enum class JpegColors {
    AsMarked,   ///< what the stream's markers say, else Y Cb Cr
    RgbUnlessMarked   ///< what a DICOM header with "RGB" means: red, green and blue where no marker says otherwise
};

/// A grey or colour JPEG; nothing when it is too large, of another kind, or less than half of its rows can be decoded.
/// `isFlawed` tells that the decoder complained: parts may be wrong, rows that are missing have the frame's mean.
std::optional<Raster> readJpeg(std::string_view content, JpegColors colors = JpegColors::AsMarked);

}   // namespace angiopose::io