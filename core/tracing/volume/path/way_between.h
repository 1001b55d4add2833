#pragma once

#include "core/tracing/volume/path/path_end.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <vector>

namespace angiopose::core {

/// The cheapest path between both ends, inclusive, through voxels that look like them (ALGORITHMS §9.12). If it is not
/// found quickly, searches blocks of voxels first and then the voxels near that path. Empty if stopped or if there is
/// no path.
std::vector<Eigen::Vector3i> wayBetween(const PathGround& ground, const PathEnd& from, const PathEnd& to,
                                        TracingProgress& progress);

}   // namespace angiopose::core
