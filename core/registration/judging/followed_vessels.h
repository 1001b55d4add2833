#pragma once

#include "core/registration/judging/distance_metrics.h"
#include "core/registration/matching/target_lines.h"

namespace angiopose::core {

/// Extent to which the tree follows traced vessels continuously instead of merely crossing them.
struct FollowedVessels {
    double inViewMm = 0.0;   ///< tree length inside the image
    double followedMm = 0.0;   ///< length of the stretches along traced vessels, each at least `minStretchMm` long
    int branchesInView = 0;   ///< number of branches with at least `minStretchMm` inside the image
    int branchesFollowed = 0;   ///< number of those branches that follow vessels over at least half of that length

    double share() const { return inViewMm > 0.0 ? followedMm / inViewMm : 0.0; }
};

inline constexpr double minStretchMm = 20.0;

/// Checks the topology after convergence (ALGORITHMS §6.9): follows each branch point by point along a vessel that is
/// close and has a similar direction. A branch that only crosses vessels does not count.
FollowedVessels followedVessels(const RegistrationProblem& problem, const TargetLines& target,
                                const RigidTransform& cameraFromPatient, const ProjectedTree& projected);

}   // namespace angiopose::core
