#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/voxel_components.h"

namespace angiopose::core {

/// Returns whether a metal component is a stent that is too thin to show lumen inside or beside it, with a vessel
/// beyond both ends; wires in bone and clips have no vessel there, leads and catheters only at one end.
bool isThinStent(const VoxelComponent& piece, const VolumeGeometry& grid, const VoxelOpacification& opacification);

}   // namespace angiopose::core
