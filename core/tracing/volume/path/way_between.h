#pragma once

#include "core/tracing/volume/path/path_end.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <vector>

namespace angiopose::core {

/// The cheapest way from one end to the other through what looks like them (ALGORITHMS §9.12), both included. Where it
/// is not found soon, blocks of voxels are searched first and the voxels near that way then. Empty when stopped, or
/// where no way is found.
std::vector<Eigen::Vector3i> wayBetween(const PathGround& ground, const PathEnd& from, const PathEnd& to,
                                        TracingProgress& progress);

}   // namespace angiopose::core
