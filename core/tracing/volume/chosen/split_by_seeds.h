#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/great_vessels/great_vessels.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_options.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Removes from a mask everything that a point to avoid reaches along a wider path than a seed does, which separates
/// connected vessels at their narrowest point (marker-based flooding of the distance map, Meyer 1994). Also removes
/// regions beyond necks (`voxelsBeyondNecks`) and, if `opacification` is given, differently opacified vessels. Ignores
/// points outside the mask. Incomplete when stopped.
///
/// A seed inside a great vessel selects that whole vessel, so all points in it give the same result; a seed outside all
/// great vessels is used unchanged. Without seeds, the first great vessel is used. Returns the start points of the
/// flooding.
std::vector<Eigen::Vector3d> splitBySeeds(VoxelMask& mask, const VesselTracingOptions& options,
                                          const VoxelOpacification& opacification,
                                          const std::vector<GreatVessel>& greatVessels, TracingProgress& progress);

}   // namespace angiopose::core
