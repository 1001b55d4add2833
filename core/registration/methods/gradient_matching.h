#pragma once

#include "core/registration/method.h"

namespace angiopose::core {

/// Matches the walls of the projected vessels with the gradients of the image; Powell's method (ALGORITHMS §3.10).
/// Source: Mitrović et al. 2013.
MethodSolution solveGradientMatching(const RegistrationProblem& problem, const RegistrationOptions& options,
                                     ProgressLog& progress);

}   // namespace angiopose::core