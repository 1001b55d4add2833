#pragma once

#include "core/case/case.h"
#include "io/opening/read_inputs.h"

namespace angiopose::io {

/// Returns `base` with the loaded parts in place of its own. A new image brings its geometry and peak-opacification
/// frame, a new tree resets the branch selections, and the pose is set to the initial pose if one can be computed.
core::Case assembleCase(core::Case base, const LoadedInputs& inputs);

/// Returns whether more than half of a tree lies within a scan; the tree is then considered traced in this scan.
bool isInsideScan(const core::VolumeGeometry& scan, const core::VesselTree& tree);

/// Returns whether the files form a complete case: a vessel tree and an angiogram.
bool isCompleteCase(const LoadedInputs& inputs);

}   // namespace angiopose::io
