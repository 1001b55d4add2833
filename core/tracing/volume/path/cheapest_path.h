#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace angiopose::core {

/// What a millimetre through a voxel costs, above 0. Asked once for each voxel that the search reaches.
using VoxelCost = std::function<double(const Eigen::Vector3i& voxel)>;

/// The cheapest way over neighbouring voxels from one to another within the part of the grid around both (Dijkstra
/// 1959); both ends included. Empty when stopped, when the part has more than 64
/// million voxels, or when 3 million were searched in vain.
std::vector<Eigen::Vector3i> cheapestPath(const VolumeGeometry& grid, const Eigen::Vector3i& from,
                                          const Eigen::Vector3i& to, const VoxelCost& costOf,
                                          TracingProgress& progress);

}   // namespace angiopose::core
