#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Voxel indices of one connected piece, ascending.
using VoxelPiece = std::vector<std::uint32_t>;

/// The 26-connected pieces of at least `minVoxels`, the largest first (of equal ones, that with the lowest voxel).
/// Incomplete when `progress`, where given, says stop.
std::vector<VoxelPiece> piecesOf(const VoxelMask& mask, std::size_t minVoxels = 1, TracingProgress* progress = nullptr);

/// The smallest box that holds everything set.
VoxelBox boxOf(const VoxelMask& mask);

/// That of a piece, with `aroundMm` to all sides as far as the grid goes.
VoxelBox boxAround(const VoxelPiece& piece, const VolumeGeometry& grid, double aroundMm);

}   // namespace angiopose::core