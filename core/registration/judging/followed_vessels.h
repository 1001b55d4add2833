#pragma once

#include "core/registration/judging/distance_metrics.h"
#include "core/registration/matching/target_lines.h"

namespace angiopose::core {

/// Measures whether the tree follows the traced vessels continuously or only crosses them.
struct FollowedVessels {
    double inViewMm = 0.0;   ///< tree length inside the image
    double followedMm = 0.0;   ///< part of it in stretches along traced vessels, each at least `shortestRunMm` long
    int branchesInView = 0;   ///< branches with at least one such length inside the image
    int branchesFollowed = 0;   ///< those matched over more than half of it

    double share() const { return inViewMm > 0.0 ? followedMm / inViewMm : 0.0; }
};

inline constexpr double shortestRunMm = 20.0;

/// Checks the topology after convergence (ALGORITHMS §6.9): follows each branch point by point along a connected
/// vessel, within `agreementPx` and in its direction; a branch that crosses other vessels does not count.
FollowedVessels followedVessels(const RegistrationProblem& problem, const TargetLines& target,
                                const RigidTransform& cameraFromPatient, const ProjectedTree& projected);

}   // namespace angiopose::core