#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Returns the skeleton of a mask as ascending voxel indices: one voxel thin, with the components, loops and cavities
/// of the mask (26-connected object, 6-connected background). Directional thinning with a queue of border voxels (Lee,
/// Kashyap, Chu 1994). Incomplete if `progress` requests a stop.
std::vector<std::size_t> skeletonize(const VoxelMask& mask, TracingProgress& progress);

/// Variant of `skeletonize` for a mask whose outermost voxels are all unset; works in place and needs no second mask.
std::vector<std::size_t> skeletonizeInPlace(VoxelMask padded, TracingProgress& progress);

}   // namespace angiopose::core
