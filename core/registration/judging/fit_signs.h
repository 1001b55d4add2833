#pragma once

#include "core/registration/judging/distance_metrics.h"
#include "core/registration/matching/target_lines.h"
#include "core/registration/problem/method_solution.h"

namespace angiopose::core {

/// A pose and where it puts the tree.
struct PoseInImage {
    const RegistrationProblem& problem;
    const TargetLines& target;
    const ProjectedTree& projected;
    const PoseUncertainty& uncertainty;
};

/// What tells how far the pose of a solution may be off.
FitSigns fitSigns(const PoseInImage& seen, const RegistrationOptions& options, const MethodSolution& solution);

}   // namespace angiopose::core
