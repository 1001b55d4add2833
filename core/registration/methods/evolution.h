#pragma once

#include "core/registration/method.h"

namespace angiopose::core {

/// Searches the pose under which vessels lie on the brightest ridges by an evolution strategy (ALGORITHMS §3.11).
/// Source: Jomier et al. 2006.
MethodSolution solveEvolution(const RegistrationProblem& problem, const RegistrationOptions& options,
                              ProgressLog& progress);

}   // namespace angiopose::core