#pragma once

#include "core/support/result.h"
#include "io/volume/stored_volume.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Parses the header of an NRRD volume (`content` is the whole file) with ITK's NRRD library: data attached or in one
/// separate file, raw or gzip. Converts any anatomical `space` to LPS. A volume without orientation causes a warning.
core::Result<StoredVolume> parseNrrd(std::string_view content, const std::string& path);

}   // namespace angiopose::io
