#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// A PNG or JPEG with its pixels as they are stored, or a TIFF with those it shows (`strippedTiff`), and nothing that
/// is written beside them: texts, times, Exif, profiles, thumbnails, what follows the end. Size in print and, of a
/// JPEG, the marker of its colours stay. Fails on others.
core::Result<std::string> strippedPicture(std::string_view picture, const std::string& path);

}   // namespace angiopose::io
