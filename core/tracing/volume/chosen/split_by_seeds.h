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
/// regions beyond necks (see `voxelsBeyondNecks`) and, if `fill` is given, vessels with a different opacification.
/// Points outside the mask are ignored. Incomplete when stopped.
///
/// A seed stands for the great vessel that contains it, so all points in that vessel give the same result; only a seed
/// outside all great vessels stands for itself. Without seeds, the first great vessel is used. Returns the start points
/// from which the vessels were flooded.
std::vector<Eigen::Vector3d> splitBySeeds(VoxelMask& mask, const VesselTracingOptions& options, const VoxelFill& fill,
                                          const std::vector<GreatVessel>& greatVessels, TracingProgress& progress);

}   // namespace angiopose::core
