#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <functional>

namespace angiopose::core {

/// Sets cavities enclosed by the mask to 2, because thinning would leave a shell around them; set voxels become 1.
/// Stops filling when `progress`, if given, requests a stop.
void fillCavities(VoxelMask& mask, TracingProgress* progress = nullptr);

/// Returns whether an unset voxel may be a hole.
using HoleFilter = std::function<bool(int i, int j, int k)>;

/// Sets voxels to 2 if most of their neighbors are set and `isHole`, if given, accepts them; larger holes need several
/// calls. Noise creates holes that are open to one side, around each of which thinning would leave a loop. Vessel walls
/// stay in place.
void fillHoles(VoxelMask& mask, const HoleFilter& isHole = {});

}   // namespace angiopose::core
