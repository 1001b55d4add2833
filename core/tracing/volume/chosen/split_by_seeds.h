#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/great_vessels/great_vessels.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_options.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Takes out of a mask what is reached from a place to avoid on a wider way than from a seed, so that vessels that hang
/// together part at their narrowest place (flooding of the distance map from markers, Meyer 1994). What lies beyond
/// necks (see `voxelsBeyondNecks`) and, where `fill` is given, vessels of other blood are avoided as well. Places that
/// lie in nothing are ignored. Incomplete when stopped.
///
/// A seed stands for the great vessel whose vessels hold it, so that all places in these give the same; only a seed in
/// none of them stands for itself. Without seeds the first great vessel is asked for. Returns the places that the
/// vessels were reached from.
std::vector<Eigen::Vector3d> splitBySeeds(VoxelMask& mask, const VesselTracingOptions& options, const VoxelFill& fill,
                                          const std::vector<GreatVessel>& greatVessels, TracingProgress& progress);

}   // namespace angiopose::core