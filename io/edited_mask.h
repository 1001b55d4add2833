#pragma once

#include "core/case/vessels.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Writes a mask as a label image with label value 1: .nrrd, .nii, .nii.gz or .mha.
core::Status writeMask(const core::VoxelMask& mask, const std::string& path);

/// Writes a case's edited lumen mask to `<case>.mask.nrrd` next to the case, unless the file is up to date, and returns
/// the file with its hash. Overwrites the file that an earlier save of the same case created; if another file of that
/// name exists, appends a number to the name.
core::Result<core::InputFile> saveEditedMask(const core::Vessels& vessels, const std::string& casePath);

}   // namespace angiopose::io
