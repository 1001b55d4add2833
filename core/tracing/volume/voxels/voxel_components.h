#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Voxel indices of one connected component, ascending.
using VoxelComponent = std::vector<std::uint32_t>;

/// Returns the 26-connected components of at least `minVoxels`, largest first (in a tie, the one with the lowest voxel
/// index first). Incomplete if `progress`, where given, requests a stop.
std::vector<VoxelComponent> connectedComponents(const VoxelMask& mask, std::size_t minVoxels = 1,
                                                TracingProgress* progress = nullptr);

/// Returns the smallest box that contains all set voxels.
VoxelBox boxOf(const VoxelMask& mask);

/// Returns the bounding box of a component, enlarged by `aroundMm` on all sides within the grid.
VoxelBox enlargedBox(const VoxelComponent& piece, const VolumeGeometry& grid, double aroundMm);

}   // namespace angiopose::core
