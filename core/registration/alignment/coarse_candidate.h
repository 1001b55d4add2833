#pragma once

#include "core/registration/pose/centroid_pose.h"

#include <vector>

namespace angiopose::core {

struct CoarseCandidate {
    CentroidPose pose;
    double score = 0.0;   ///< mean closeness of the tree points to the target, 0…1
};

/// Largest difference between two poses that are considered to converge to the same optimum.
struct Basin {
    double shiftMm;
    double turn;   ///< rad
};

/// Returns the best candidate of each basin, best first: at most twelve that score nearly as well as the first.
std::vector<CoarseCandidate> distinctCandidates(std::vector<CoarseCandidate> candidates, const Basin& basin);

}   // namespace angiopose::core
