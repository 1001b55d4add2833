#pragma once

#include "core/registration/judging/distance_metrics.h"
#include "core/registration/matching/target_lines.h"
#include "core/registration/problem/method_solution.h"

namespace angiopose::core {

/// Pose with the resulting projection of the tree.
struct PoseInImage {
    const RegistrationProblem& problem;
    const TargetLines& target;
    const ProjectedTree& projected;
    const PoseUncertainty& uncertainty;
};

/// Computes the signs from which the error of a solution's pose is estimated.
FitSigns fitSigns(const PoseInImage& seen, const RegistrationOptions& options, const MethodSolution& solution);

}   // namespace angiopose::core
