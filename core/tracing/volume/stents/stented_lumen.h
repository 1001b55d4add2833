#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/stents/stent_site.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/tracing/volume/voxels/voxel_components.h"

namespace angiopose::core {

/// Returns the lumen beside stent struts that segmentation left out: up to the brightest line of each strut, where the
/// vessel wall lies, and between struts as far as opacified lumen is visible, within at most `steps` voxels. Lumens
/// separated by struts stay separate, like those of an aortic dissection. Two parts are merged if their opacification
/// is the same (measured in voxels above 1) or a vessel is too thin to decide, and if lumen is visible over most of
/// their contact area or in an area no larger than a branch. Incomplete when stopped.
VoxelComponent growLumenBesideStruts(const VoxelMask& lumen, const StentStruts& wires,
                                     const VoxelOpacification& opacification, int steps, TracingProgress& progress);

}   // namespace angiopose::core
