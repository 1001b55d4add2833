#pragma once

#include "core/imaging/image2d.h"
#include "core/support/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Frames of a PNG, JPEG or (multi-page) TIFF as grey values.
struct Raster {
    std::vector<core::ImageF> frames;
    bool wasColor = false;   ///< channels differed; their luminance was taken
    bool hadAlpha = false;   ///< transparency was ignored
    bool isFlawed = false;   ///< damaged in part: what could be decoded is there
    int orientation = 1;   ///< tag of a frame that was turned or mirrored for it; 1: stored as shown

    /// Grey of a pixel (Rec. 601), exact where the channels agree; notes where they do not.
    float luminance(float red, float green, float blue);
};

/// True when the content begins like one of the formats.
bool looksLikeRaster(std::string_view content);

/// `content` is what `path` holds; the libraries read the path itself. Frames come as their orientation tag (EXIF,
/// TIFF) has them shown.
core::Result<Raster> readRaster(std::string_view content, const std::string& path);

}   // namespace angiopose::io