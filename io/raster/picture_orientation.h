#pragma once

#include "core/imaging/image2d.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns the EXIF orientation of a JPEG or PNG, 1 (as stored) to 8; 1 if none is stated.
int exifOrientation(std::string_view picture);

/// Returns EXIF data that state only an orientation.
std::string exifOf(int orientation);

/// Returns the image in its display orientation (TIFF 6.0, tag 274).
core::ImageF oriented(const core::ImageF& stored, int orientation);

}   // namespace angiopose::io
