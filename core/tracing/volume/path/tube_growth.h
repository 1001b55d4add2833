#pragma once

#include "core/tracing/tree/branch_paths.h"
#include "core/tracing/volume/path/path_ground.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <vector>

namespace angiopose::core {

/// Radius beyond which nothing is a thin vessel.
inline constexpr double widestTubeMm = 5.0;

/// Where tubes lead from seeds.
struct GrownTubes {
    std::vector<BranchPath> paths;   ///< parents before children; mm along the grid's axes, radii assumed
    VesselLook look;   ///< of all of them, the median
    bool isCutShort = false;   ///< more was reached than is searched
};

struct TubeLimits {
    double minBranchLengthMm = 4.0;
    double assumedRadiusMm = 1.5;
};

/// Grows from seed voxels over what is the middle of a tube (ALGORITHMS §9.13): a way may cross a few mm of anything
/// else, at a debt that tube pays back. Every branch is the cheapest way to the end it was grown to. Empty when
/// stopped.
GrownTubes growTubes(const PathGround& ground, const std::vector<Eigen::Vector3i>& seeds, const TubeLimits& limits,
                     TracingProgress& progress);

}   // namespace angiopose::core
