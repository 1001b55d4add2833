#pragma once

#include "core/tracing/volume/lumen/blood_level.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/voxel_pieces.h"

namespace angiopose::core {

/// Selects the part of a component brighter than blood that is a stent: it is somewhere brighter than any bone, has
/// thin wires, and has blood next to much of it or, if it is too thin for that, beyond both ends. Wires in bone, skin
/// electrodes, devices and dense contrast agent fail one of these tests. If bone is so close that it belongs to the
/// same component, only the surroundings of the brightest voxels are taken. Empty if there is no stent.
VoxelPiece metalInBlood(const VoxelPiece& piece, const VolumeGeometry& grid, const BloodLevel& level,
                        const VoxelFill& fill);

}   // namespace angiopose::core