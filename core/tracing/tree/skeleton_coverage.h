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
    double fraction = 1.0;   ///< covered fraction (within two voxels); only components with curves
    std::optional<Eigen::Vector3d> missedInPatient;   ///< point in the largest uncovered segment, LPS, mm
};

/// Measures the fraction of `skeleton` (voxels of `grid`, ascending) that the curves cover.
SkeletonCoverage measureCoverage(const VolumeGeometry& grid, const std::vector<std::size_t>& skeleton,
                                 const VesselTree& tree);

}   // namespace angiopose::core
