#pragma once

#include "io/raster/read_raster.h"

#include <optional>
#include <string>

namespace angiopose::io {

/// Pages of a TIFF as frames: grey or RGB, 8 or 16 bits or float, in strips. Nothing for any other kind, damaged or too
/// large files. Read by libtiff itself, since ITK's reader trusts a damaged directory.
std::optional<Raster> readTiff(const std::string& path);

}   // namespace angiopose::io