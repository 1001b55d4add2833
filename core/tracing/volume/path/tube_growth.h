#pragma once

#include "core/tracing/tree/branch_paths.h"
#include "core/tracing/volume/path/tube_detector.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <vector>

namespace angiopose::core {

/// Maximum radius of a thin vessel.
inline constexpr double maxTubeRadiusMm = 5.0;

/// Tubes grown from seeds.
struct TubePaths {
    std::vector<BranchPath> paths;   ///< parents before children; mm along the grid's axes, radii assumed
    VesselAppearance appearance;   ///< median appearance of all tubes
    bool isTruncated = false;   ///< whether the search limit was reached
};

struct TubeLimits {
    double minBranchLengthMm = 4.0;
    double assumedRadiusMm = 1.5;
};

/// Grows tubes from seed voxels along tube centers (ALGORITHMS §9.13): a path may cross a few mm of other material,
/// which incurs a debt that tube voxels pay back. Every branch is the cheapest path to its end. Empty when stopped.
TubePaths growTubes(const TubeDetector& detector, const std::vector<Eigen::Vector3i>& seeds, const TubeLimits& limits,
                    TracingProgress& progress);

}   // namespace angiopose::core
