#pragma once

#include "io/raster/read_raster.h"

#include <string>

namespace angiopose::io {

/// Reads the pages of a TIFF as frames, except thumbnails and masks: grayscale or RGB, 8 or 16 bits or float, in
/// strips. Fails for any other kind of TIFF, for pages of different sizes, and for damaged or too large files. Uses
/// libtiff directly, because ITK's reader does not detect a damaged directory.
core::Result<Raster> readTiff(const std::string& path);

}   // namespace angiopose::io
