#pragma once

#include "core/support/result.h"
#include "io/volume/stored_volume.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Header of an NRRD volume (`content`: the whole file) by ITK's NRRD library, data attached or in one file beside it,
/// raw or gzip; any anatomical `space` turned to LPS. A volume without orientation says so in a warning.
core::Result<StoredVolume> parseNrrd(std::string_view content, const std::string& path);

}   // namespace angiopose::io
