#pragma once

#include "core/imaging/reduce_volume.h"
#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace angiopose::core {

/// Cost per millimeter through a voxel, positive or (if impassable) infinite; evaluated once per voxel reached.
struct VoxelCost {
    std::function<double(const Eigen::Vector3i& voxel)> perMm;
    double minPerMm = 0.0;   ///< lower bound of all costs; a tight bound speeds up the search
};

/// Result of a path search.
struct MinimalPath {
    std::vector<Eigen::Vector3i> voxels;   ///< path including both ends; empty if none was found
    bool isTruncated = false;   ///< whether the search limit was reached
};

/// Returns the voxel range of the search: the box around both ends, enlarged by 15 to 40 mm.
VoxelRange searchRange(const VolumeGeometry& grid, const Eigen::Vector3i& from, const Eigen::Vector3i& to);

/// Finds the cheapest path between two voxels within `searchRange` by bidirectional search with the straight-line
/// distance as heuristic (Dijkstra 1959; Ikeda et al. 1994). Empty when stopped, if every path is blocked, or if
/// `maxSettled` voxels were searched without success.
MinimalPath findMinimalPath(const VolumeGeometry& grid, const Eigen::Vector3i& from, const Eigen::Vector3i& to,
                            const VoxelCost& cost, std::size_t maxSettled, TracingProgress& progress);

}   // namespace angiopose::core
