#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/voxel_pieces.h"

namespace angiopose::core {

/// Whether a piece of metal is a tube so thin that no blood is seen within or beside it, with a vessel beyond both its
/// ends: wires in bone and clips have none, a lead or a catheter only at one.
bool isThinStent(const VoxelPiece& piece, const VolumeGeometry& grid, const VoxelFill& fill);

}   // namespace angiopose::core