#pragma once

#include "core/imaging/image2d.h"
#include "core/support/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Frames of a PNG, JPEG or (multi-page) TIFF, converted to grayscale.
struct Raster {
    std::vector<core::ImageF> frames;
    bool wasColor = false;   ///< whether the channels differed and were converted to luminance
    bool hadAlpha = false;   ///< whether transparency was ignored
    bool isPartlyDamaged = false;   ///< whether the image is partly damaged and only the intact part was decoded
    int orientation = 1;   ///< orientation tag by which the frames were rotated or mirrored; 1 if stored as displayed

    /// Converts a color to grayscale (Rec. 601), exactly if the channels are equal.
    float luminance(float red, float green, float blue);
};

/// Returns whether the content starts like a PNG, JPEG or TIFF.
bool looksLikeRaster(std::string_view content);

/// Reads an image file. `content` holds all bytes of the file at `path`, which some libraries read again. The frames
/// have the display orientation specified in the file (EXIF, TIFF).
core::Result<Raster> readRaster(std::string_view content, const std::string& path);

}   // namespace angiopose::io
