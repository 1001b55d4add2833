#pragma once

#include "core/tracing/volume/lumen/blood_level.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/voxel_pieces.h"

namespace angiopose::core {

/// What of a piece that is brighter than blood is a stent: somewhere brighter than any bone, of thin wires, and with
/// blood beside much of it or, where it is too thin for that, beyond both its ends. Wires in bone, electrodes on the
/// skin, devices and dense contrast medium lack one of these. Where bone is so close that it is in the same piece, what
/// lies around the brightest voxels alone. Empty when nothing is.
VoxelPiece metalInBlood(const VoxelPiece& piece, const VolumeGeometry& grid, const BloodLevel& level,
                        const VoxelFill& fill);

}   // namespace angiopose::core