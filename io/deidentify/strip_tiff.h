#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// True if the content begins like a TIFF.
bool looksLikeTiff(std::string_view content);

/// Returns a TIFF with the decoded pixels of its pages, bit by bit, and only the tags needed to show them: no texts,
/// times, Exif, GPS, XMP, profiles, private tags, thumbnails or unreferenced data. Compresses pages losslessly if they
/// were compressed. Fails for the kinds that `readTiff` rejects.
core::Result<std::string> strippedTiff(std::string_view tiff, const std::string& path);

}   // namespace angiopose::io
