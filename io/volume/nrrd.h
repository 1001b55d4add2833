#pragma once

#include "core/support/result.h"
#include "io/volume/stored_volume.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Parses the header of an NRRD volume (`content` is the whole file) with ITK's NRRD library; the data may be attached
/// or in one separate file, raw or gzip. Converts any anatomical `space` to LPS. Warns if the orientation is missing.
core::Result<StoredVolume> parseNrrd(std::string_view content, const std::string& path);

}   // namespace angiopose::io
