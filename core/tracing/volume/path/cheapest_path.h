#pragma once

#include "core/imaging/reduce_volume.h"
#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace angiopose::core {

/// What a millimetre through a voxel costs, above 0; infinite: it is not entered. Asked once for each voxel that the
/// search reaches.
struct VoxelCost {
    std::function<double(const Eigen::Vector3i& voxel)> perMm;
    double minPerMm = 0.0;   ///< no voxel costs less; the nearer the truth, the fewer are searched
};

/// What a search came to.
struct CheapestPath {
    std::vector<Eigen::Vector3i> voxels;   ///< both ends included; empty: none was found
    bool isCutShort = false;   ///< as many were searched as it was allowed
};

/// The voxels between which a way is searched: the box around both ends, 15 to 40 mm wider.
VoxelRange searchedRange(const VolumeGeometry& grid, const Eigen::Vector3i& from, const Eigen::Vector3i& to);

/// The cheapest way over neighbouring voxels from one to another within `searchedRange`, sought from both ends and
/// first where the straight way on is short (Dijkstra 1959; Ikeda et al. 1994). None when stopped, where all is closed,
/// or when `maxSettled` voxels were searched in vain.
CheapestPath cheapestPath(const VolumeGeometry& grid, const Eigen::Vector3i& from, const Eigen::Vector3i& to,
                          const VoxelCost& cost, std::size_t maxSettled, TracingProgress& progress);

}   // namespace angiopose::core
