#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns a PNG or JPEG with its pixels as stored, or a TIFF with its visible pixels (`strippedTiff`), without
/// metadata: texts, times, Exif, profiles, thumbnails, trailing data. Keeps the print size and, in a JPEG, the color
/// marker. Fails for other formats.
core::Result<std::string> strippedPicture(std::string_view picture, const std::string& path);

}   // namespace angiopose::io
