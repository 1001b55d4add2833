#pragma once

#include "core/case/vessels.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Writes a mask as a label image with label 1: .nrrd, .nii, .nii.gz or .mha.
core::Status writeMask(const core::VoxelMask& mask, const std::string& path);

/// Writes a case's edited lumen mask to `<case>.mask.nrrd` beside it, unless already there, and returns the file with
/// its hash. Replaces the file of an earlier save of the same case; another existing file stays, and the name gets a
/// number.
core::Result<core::InputFile> keepEditedMask(const core::Vessels& vessels, const std::string& casePath);

}   // namespace angiopose::io
