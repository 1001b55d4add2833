#pragma once

#include "core/support/result.h"
#include "io/volume/stored_volume.h"

#include <optional>
#include <string>

namespace angiopose::io {

enum class VolumeFormat { Nifti, Nrrd, MetaImage };

/// By the first bytes, packed ones unpacked; nothing for other content or when the file cannot be read.
std::optional<VolumeFormat> volumeFormatOf(const std::string& path);

/// Header of a volume file; fails with file, problem and remedy. Own readers rather than ITK's: those fill a buffer of
/// the stored type that is then converted (a second copy of the scan), in one call that can neither report nor stop,
/// and name neither the line nor the remedy of what is wrong.
core::Result<StoredVolume> openStored(const std::string& path);

}   // namespace angiopose::io