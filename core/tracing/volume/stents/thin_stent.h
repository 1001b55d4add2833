#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/voxel_pieces.h"

namespace angiopose::core {

/// Whether a metal component is a tube too thin to show blood inside or beside it, with a vessel beyond both ends:
/// wires in bone and clips have none, a lead or catheter only at one end.
bool isThinStent(const VoxelPiece& piece, const VolumeGeometry& grid, const VoxelFill& fill);

}   // namespace angiopose::core