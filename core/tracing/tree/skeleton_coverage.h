#pragma once

#include "core/imaging/volume.h"
#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace angiopose::core {

/// Coverage of a lumen's skeleton by the traced curves.
struct SkeletonCoverage {
    double fraction = 1.0;   ///< fraction covered (within two voxels) of the components with curves
    std::optional<Eigen::Vector3d> missedInPatient;   ///< point in the largest uncovered segment, LPS, mm
};

/// Returns the coverage of `skeleton` (voxels of `grid`, ascending) by the curves.
SkeletonCoverage measureCoverage(const VolumeGeometry& grid, const std::vector<std::size_t>& skeleton,
                                 const VesselTree& tree);

}   // namespace angiopose::core
