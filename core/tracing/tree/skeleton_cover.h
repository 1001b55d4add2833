#pragma once

#include "core/imaging/volume.h"
#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace angiopose::core {

/// Share of a lumen's own skeleton that the curves cover.
struct SkeletonCover {
    double share = 1.0;   ///< share of its voxels within two voxels of the curves; only in components with curves
    std::optional<Eigen::Vector3d> missedInPatient;   ///< in the longest uncovered stretch, LPS mm
};

/// Measures how much of `skeleton` (voxels of `grid`, ascending) the curves cover.
SkeletonCover skeletonCover(const VolumeGeometry& grid, const std::vector<std::size_t>& skeleton,
                            const VesselTree& tree);

}   // namespace angiopose::core
