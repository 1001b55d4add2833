#pragma once

#include "core/imaging/image2d.h"
#include "core/support/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Frames of a PNG, JPEG or (multi-page) TIFF as gray values.
struct Raster {
    std::vector<core::ImageF> frames;
    bool wasColor = false;   ///< channels differed and were converted to luminance
    bool hadAlpha = false;   ///< transparency was ignored
    bool isFlawed = false;   ///< partly damaged: contains what could be decoded
    int orientation =
        1;   ///< orientation tag of a frame that was rotated or mirrored accordingly; 1: stored as displayed

    /// Converts colors to gray (Rec. 601), exact if the channels agree; records whether they differ.
    float luminance(float red, float green, float blue);
};

/// Returns true if the content begins like one of these formats.
bool looksLikeRaster(std::string_view content);

/// Reads an image file; `content` is the content of `path`, which the libraries read themselves. Frames have the
/// display orientation of their tag (EXIF, TIFF).
core::Result<Raster> readRaster(std::string_view content, const std::string& path);

}   // namespace angiopose::io