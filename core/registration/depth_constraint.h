#pragma once

#include "core/registration/problem/method_solution.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Returns the solution refined at the depth of the initial pose if, according to `assessed`, the image does not
/// determine the depth (ALGORITHMS §6.19). Returns nullopt if the depth is determined, locked or hardly changed.
std::optional<MethodSolution> constrainDepth(const RegistrationProblem& problem, const RegistrationOptions& options,
                                             const MethodSolution& solution, const RegistrationResult& assessed);

}   // namespace angiopose::core
