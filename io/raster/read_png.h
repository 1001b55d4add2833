#pragma once

#include "io/raster/read_raster.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Decodes any PNG with libpng. Fails if a checksum is wrong, data are missing before its end, or it is too small or
/// too large; allocates memory only after the header has passed these limits.
core::Result<Raster> readPng(std::string_view content, const std::string& path);

}   // namespace angiopose::io
