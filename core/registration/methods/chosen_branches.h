#pragma once

#include "core/registration/alignment/graduated_refinement.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// The fit of the branches that the user chose as auxiliary, beside the fit of all.
struct ChosenFit {
    CentroidPose pose;
    double medianPx = 0.0;   ///< of the chosen branches' points to the traced vessels
    double medianBeforePx = 0.0;   ///< the same in the fit of all
};

/// {p'} solved alone from the fit of all: Σ r² of the chosen branches + sᵀ H s / weight for the step s away from that
/// fit, H what all branches and the start pose tell (ALGORITHMS §6). So the chosen branches decide what they can tell,
/// and the others hold the rest. The fit of all stays where the chosen branches would lie no better. Only where
/// branches are chosen.
ChosenFit fitChosenBranches(const RegistrationProblem& problem, const TargetLines& target, const StartPrior& prior,
                            const CentroidPose& fitOfAll, double weight);

}   // namespace angiopose::core
