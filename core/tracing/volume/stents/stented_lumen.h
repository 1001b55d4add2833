#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/stents/stent_site.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/tracing/volume/voxels/voxel_pieces.h"

namespace angiopose::core {

/// Lumen beside stent wires, from which the segmentation kept clear: up to the crest of each wire, where its middle and
/// the vessel's wall lie, and between wires as far as blood is visible, within at most `steps` voxels. Lumens separated
/// by wires stay separate, as those of an aortic dissection. Two parts become one if their blood is the same (voxels
/// above 1 are inner ones) or a vessel is too thin to decide, and if blood is visible over most of their contact area
/// or in an area no larger than a branch. Incomplete when stopped.
VoxelPiece lumenBesideWires(const VoxelMask& lumen, const StentWires& wires, const VoxelFill& fill, int steps,
                            TracingProgress& progress);

}   // namespace angiopose::core