#pragma once

#include "core/imaging/image2d.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns the EXIF orientation of a JPEG or PNG, from 1 (as stored) to 8; 1 if not specified.
int exifOrientation(std::string_view picture);

/// Returns EXIF data that contain only an orientation.
std::string makeExif(int orientation);

/// Returns the image rotated or mirrored for display (TIFF 6.0, tag 274).
core::ImageF applyOrientation(const core::ImageF& stored, int orientation);

}   // namespace angiopose::io
