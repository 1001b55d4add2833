#pragma once

#include "io/raster/read_raster.h"

#include <string>

namespace angiopose::io {

/// Reads the pages of a TIFF as frames, without thumbnails and masks: gray or RGB, 8 or 16 bits or float, in strips.
/// Fails on any other kind, on pages of different sizes, and on damaged or too large files. Uses libtiff directly,
/// since ITK's reader does not check for a damaged directory.
core::Result<Raster> readTiff(const std::string& path);

}   // namespace angiopose::io