#pragma once

#include "core/tracing/volume/lumen/lumen_levels.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/voxel_components.h"

namespace angiopose::core {

/// Returns the part of a bright component that is a stent: brighter than any bone in places, with thin struts, and
/// bordered by opacified lumen on much of its surface or, if too thin for that, beyond both ends. Wires in bone, skin
/// electrodes, devices and dense contrast agent fail one of these tests. If bone is close enough to belong to the same
/// component, only the surroundings of the brightest voxels are used. Empty if there is no stent.
VoxelComponent findStentPart(const VoxelComponent& piece, const VolumeGeometry& grid, const LumenLevels& level,
                             const VoxelOpacification& fill);

}   // namespace angiopose::core
