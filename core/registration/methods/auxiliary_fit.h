#pragma once

#include "core/registration/alignment/graduated_refinement.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Fit of the auxiliary branches selected by the user, compared with the fit of all branches.
struct AuxiliaryFit {
    CentroidPose pose;
    double medianPx = 0.0;   ///< median distance from the auxiliary branches to the traced vessels
    double medianBeforePx = 0.0;   ///< the same distance for the fit of all branches
};

/// Solves {p'} starting from the fit of all branches: minimizes Σ r² of the auxiliary branches + sᵀ H s / weight for
/// the step s away from that fit, where H is the information of all branches and the initial pose (ALGORITHMS §6). The
/// auxiliary branches thereby determine the directions that they constrain, and the other branches determine the rest.
/// Keeps the fit of all branches if the auxiliary branches would not fit better. Requires that the user has chosen
/// auxiliary branches.
AuxiliaryFit fitAuxiliaryBranches(const RegistrationProblem& problem, const TargetLines& target,
                                  const InitialPosePrior& prior, const CentroidPose& fullFit, double weight);

}   // namespace angiopose::core
