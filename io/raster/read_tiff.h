#pragma once

#include "io/raster/read_raster.h"

#include <string>

namespace angiopose::io {

/// Pages of a TIFF as frames, without thumbnails and masks of them: grey or RGB, 8 or 16 bits or float, in strips.
/// Fails on any other kind, pages of several sizes, damaged or too large files. Read by libtiff itself, since ITK's
/// reader trusts a damaged directory.
core::Result<Raster> readTiff(const std::string& path);

}   // namespace angiopose::io