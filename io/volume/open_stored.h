#pragma once

#include "core/support/result.h"
#include "io/volume/stored_volume.h"

#include <optional>
#include <string>

namespace io {

enum class VolumeFormat { Nifti, Nrrd, MetaImage };

/// By the first bytes, packed ones unpacked; nothing for other content or when the file cannot be read.
std::optional<VolumeFormat> volumeFormatOf(const std::string& path);

/// Header of a volume file; fails with file, problem and remedy.
core::Result<StoredVolume> openStored(const std::string& path);

}   // namespace io
