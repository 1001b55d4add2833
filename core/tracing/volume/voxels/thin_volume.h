#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Skeleton of a mask as ascending voxel indices: one voxel thin, with the mask's pieces, loops and cavities
/// (26-connected object, 6-connected background). Directional thinning with a queue of border voxels (Lee, Kashyap,
/// Chu 1994). Incomplete when `progress` says stop.
std::vector<std::size_t> thinned(const VoxelMask& mask, TracingProgress& progress);

/// The same for a mask whose outermost voxels are all clear; works within it and so needs no second one.
std::vector<std::size_t> thinnedInPlace(VoxelMask rimmed, TracingProgress& progress);

}   // namespace angiopose::core