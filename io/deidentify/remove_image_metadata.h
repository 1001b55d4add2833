#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns the image without metadata (text, times, Exif, profiles, thumbnails, trailing data): PNG and JPEG with the
/// stored pixel data, TIFF with the visible pixels (`removeTiffMetadata`). Keeps the print size and, in a JPEG, the
/// marker for the color space. Fails for other formats.
core::Result<std::string> removeImageMetadata(std::string_view picture, const std::string& path);

}   // namespace angiopose::io
