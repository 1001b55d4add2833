#pragma once

#include "core/registration/judging/distance_metrics.h"
#include "core/registration/matching/target_lines.h"

namespace angiopose::core {

/// How a tree runs along the traced vessels: unbroken, or only where it happens to cross them.
struct FollowedVessels {
    double inViewMm = 0.0;   ///< length of the tree inside the image
    double followedMm = 0.0;   ///< of it in runs along traced vessels, each at least `shortestRunMm` long
    int branchesInView = 0;   ///< with at least one such length inside the image
    int branchesFollowed = 0;   ///< of them, those that are followed over half of it

    double share() const { return inViewMm > 0.0 ? followedMm / inViewMm : 0.0; }
};

inline constexpr double shortestRunMm = 20.0;

/// Topology after convergence (ALGORITHMS §6.9): a branch whose matched vessel is connected is followed point by point,
/// within `agreementPx` and in its direction; a branch that lies across other vessels is not.
FollowedVessels followedVessels(const RegistrationProblem& problem, const TargetLines& target,
                                const RigidTransform& cameraFromPatient, const ProjectedTree& projected);

}   // namespace angiopose::core