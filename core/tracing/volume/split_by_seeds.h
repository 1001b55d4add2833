#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/tracing_progress.h"

#include <Eigen/Core>
#include <vector>

namespace core {

/// Takes out of a mask what is reached from a place to avoid on a wider way than from a seed, so that vessels that hang
/// together part at their narrowest place (flooding of the distance map from markers, Meyer 1994). What lies beyond
/// necks (see `voxelsBeyondNecks`) is avoided as well. Places (LPS mm) that lie in nothing are ignored. Incomplete when
/// stopped.
void splitBySeeds(VoxelMask& mask, const std::vector<Eigen::Vector3d>& seedsInPatient,
                  const std::vector<Eigen::Vector3d>& avoidInPatient, int threads, TracingProgress& progress);

}   // namespace core
