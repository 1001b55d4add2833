#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns whether the content starts like a TIFF file.
bool looksLikeTiff(std::string_view content);

/// Returns a TIFF with the decoded pixels of all pages, bit for bit, and only the tags required for display: no text,
/// times, Exif, GPS, XMP, profiles, private tags, thumbnails or unreferenced data. Compresses pages losslessly if they
/// were compressed before. Fails for the kinds of TIFF that `readRaster` rejects.
core::Result<std::string> removeTiffMetadata(std::string_view tiff, const std::string& path);

}   // namespace angiopose::io
