#pragma once

#include "core/registration/method.h"

namespace angiopose::core {

/// Our own method (ALGORITHMS §6): coarse search → robust refinement of the best hypotheses → full refinement of the
/// best one, all about the tree's centroid.
MethodSolution solveAngioPose(const RegistrationProblem& problem, const RegistrationOptions& options,
                              ProgressLog& progress);

}   // namespace angiopose::core