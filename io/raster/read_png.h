#pragma once

#include "io/raster/read_raster.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Decodes a PNG of any kind through libpng. Fails if a checksum is wrong, the file is truncated, or the image is too
/// small or too large; allocates memory only after the header has passed the size limits.
core::Result<Raster> readPng(std::string_view content, const std::string& path);

}   // namespace angiopose::io
