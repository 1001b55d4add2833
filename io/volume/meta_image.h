#pragma once

#include "core/support/result.h"
#include "io/volume/stored_volume.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Header of a MetaImage volume (.mha, or .mhd with its voxels beside it), raw or packed with zlib; patient LPS.
core::Result<StoredVolume> parseMetaImage(std::string_view content, const std::string& path);

}   // namespace angiopose::io