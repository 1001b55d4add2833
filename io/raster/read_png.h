#pragma once

#include "io/raster/read_raster.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// A PNG of any kind, by libpng. Fails when a checksum is wrong, anything is missing up to its end, or it is too small
/// or too large; memory is taken only after that is known of its header.
core::Result<Raster> readPng(std::string_view content, const std::string& path);

}   // namespace angiopose::io
