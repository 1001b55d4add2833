#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/stents/stent_site.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/tracing/volume/voxels/voxel_pieces.h"

namespace angiopose::core {

/// What belongs to the lumen beside wires, where it was kept clear of all that they blur: up to the crest of each wire,
/// where its middle and the vessel's wall lie, and between wires as far as blood is seen, in at most `steps` voxels.
/// What wires part stays apart, as the lumens of a torn aorta do. Two parts become one where the blood is the same
/// (voxels above 1 are inner ones) or a vessel is too thin to tell, and it is seen between wires mostly, or in a place
/// no larger than a branch. Incomplete when stopped.
VoxelPiece lumenBesideWires(const VoxelMask& lumen, const StentWires& wires, const VoxelFill& fill, int steps,
                            TracingProgress& progress);

}   // namespace angiopose::core