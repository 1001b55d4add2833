#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <functional>

namespace angiopose::core {

/// Sets to 2 what is enclosed by the mask: thinning would leave a shell around it. What was set becomes 1. Nothing more
/// is filled once `progress`, where given, says stop.
void fillCavities(VoxelMask& mask, TracingProgress* progress = nullptr);

/// Whether a voxel that is not set may be a hole.
using HoleFilter = std::function<bool(int i, int j, int k)>;

/// Sets to 2 what most neighbours of are set and, where given, `isHole` agrees to; larger holes take several rounds.
/// Noise makes holes that are open to a side, and thinning would leave a loop around each. Walls of vessels stay where
/// they are.
void fillHoles(VoxelMask& mask, const HoleFilter& isHole = {});

}   // namespace angiopose::core