#pragma once

#include "core/support/result.h"
#include "io/volume/stored_volume.h"

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Volume formats with a simple header: MetaImage (.mha, or .mhd with a separate voxel file), legacy VTK images, GIPL.
enum class PlainFormat { MetaImage, VtkImage, Gipl };

/// Determines the format from the first bytes and, if these are ambiguous, from the extension.
std::optional<PlainFormat> plainFormatOf(std::string_view content, const std::string& path);

/// Parses the header of such a volume (patient LPS); `content` is the whole file. Warns if it states no orientation.
core::Result<StoredVolume> openPlainVolume(PlainFormat format, std::string_view content, const std::string& path);

}   // namespace angiopose::io
