#pragma once

#include "core/case/case.h"
#include "io/opening/read_inputs.h"

namespace angiopose::io {

/// `base` with the loaded parts in place of its own: a new image brings its geometry and fullest frame, a new tree
/// forgets branch choices, and the pose goes to the start pose where one can be had.
core::Case withInputs(core::Case base, const LoadedInputs& inputs);

/// Whether most of a tree lies within a scan: then it is of this scan, however it was made.
bool liesIn(const core::VolumeGeometry& scan, const core::VesselTree& tree);

/// True when the files make a case by themselves: a vessel tree and an angiogram.
bool makesNewCase(const LoadedInputs& inputs);

}   // namespace angiopose::io
