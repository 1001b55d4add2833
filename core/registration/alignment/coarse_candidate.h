#pragma once

#include "core/registration/pose/centroid_pose.h"

#include <vector>

namespace angiopose::core {

struct CoarseCandidate {
    CentroidPose pose;
    double score = 0.0;   ///< mean closeness of the tree to the target, 0…1
};

/// How near two poses must be to lead to the same optimum.
struct Basin {
    double shiftMm;
    double turn;   ///< rad
};

/// The best candidate of each basin, best first: the leading twelve, as far as they score nearly as well as the first.
std::vector<CoarseCandidate> distinct(std::vector<CoarseCandidate> candidates, const Basin& basin);

}   // namespace angiopose::core