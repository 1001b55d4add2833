#pragma once

#include "core/support/result.h"
#include "io/volume/stored_volume.h"

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Volumes with a short header: MetaImage (.mha, or .mhd with its voxels beside it), legacy VTK images, GIPL.
enum class PlainFormat { MetaImage, VtkImage, Gipl };

/// By the first bytes, and the extension where these do not decide.
std::optional<PlainFormat> plainFormatOf(std::string_view content, const std::string& path);

/// The header of such a volume (`content`: the whole file), patient LPS; one without orientation says so in a warning.
core::Result<StoredVolume> openPlainVolume(PlainFormat format, std::string_view content, const std::string& path);

}   // namespace angiopose::io
