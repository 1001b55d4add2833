#pragma once

#include "core/case/vessels.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// A mask as a label image of label 1: .nrrd, .nii, .nii.gz or .mha.
core::Status writeMask(const core::VoxelMask& mask, const std::string& path);

/// The file of a case's edited lumen mask, with its hash: each case has its own, `<case>.mask.nrrd` beside it. Written
/// unless it is there already; the file of an earlier save of the same case is replaced, any other of that name is left
/// alone and a number added to the name.
core::Result<core::InputFile> keepEditedMask(const core::Vessels& vessels, const std::string& casePath);

}   // namespace angiopose::io
