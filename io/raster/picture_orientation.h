#pragma once

#include "core/imaging/image2d.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Orientation of the EXIF data of a JPEG or PNG, 1 (as stored) to 8; 1 where none is stated.
int exifOrientation(std::string_view picture);

/// EXIF data that state an orientation and nothing else.
std::string exifOf(int orientation);

/// The image as it is meant to be shown: TIFF 6.0, tag 274.
core::ImageF oriented(const core::ImageF& stored, int orientation);

}   // namespace angiopose::io
