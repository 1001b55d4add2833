#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/great_vessels/great_vessels.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_options.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Removes from a mask everything that is reached from a place to avoid on a wider path than from a seed, so connected
/// vessels are separated at their narrowest place (marker-based flooding of the distance map, Meyer 1994). Regions
/// beyond necks (see `voxelsBeyondNecks`) and, if `fill` is given, vessels with other blood are avoided as well. Places
/// outside the mask are ignored. Incomplete when stopped.
///
/// A seed stands for the great vessel whose vessels contain it, so all places in them give the same result; only a seed
/// outside all of them stands for itself. Without seeds the first great vessel is used. Returns the places that the
/// vessels were reached from.
std::vector<Eigen::Vector3d> splitBySeeds(VoxelMask& mask, const VesselTracingOptions& options, const VoxelFill& fill,
                                          const std::vector<GreatVessel>& greatVessels, TracingProgress& progress);

}   // namespace angiopose::core