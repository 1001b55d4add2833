#pragma once

#include "core/imaging/volume.h"
#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace angiopose::core {

/// How much of a lumen's own skeleton the curves follow.
struct SkeletonCover {
    double share = 1.0;   ///< of its voxels, within two voxels of the curves; pieces without any curve do not count
    std::optional<Eigen::Vector3d> missedInPatient;   ///< in the longest stretch that is not followed, LPS mm
};

/// `skeleton`: voxels of `grid`, ascending.
SkeletonCover skeletonCover(const VolumeGeometry& grid, const std::vector<std::size_t>& skeleton,
                            const VesselTree& tree);

}   // namespace angiopose::core
