#pragma once

#include "core/support/result.h"
#include "io/volume/stored_volume.h"

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Volumes that ITK's own classes read: MetaImage (.mha, or .mhd with its voxels beside it), legacy VTK images, GIPL.
enum class ItkFormat { MetaImage, VtkImage, Gipl };

/// By the first bytes, and the extension where these do not decide.
std::optional<ItkFormat> itkFormatOf(std::string_view content, const std::string& path);

/// The header of such a volume (`content`: the whole file), patient LPS; one without orientation says so in a warning.
core::Result<StoredVolume> openItkVolume(ItkFormat format, std::string_view content, const std::string& path);

}   // namespace angiopose::io
