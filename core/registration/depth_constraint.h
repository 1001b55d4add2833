#pragma once

#include "core/registration/problem/method_solution.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Solution refined at the depth of the initial pose, if `judged` shows that the image does not determine the depth
/// (ALGORITHMS §6.19). Returns nullopt if it does or if the depth did not change.
std::optional<MethodSolution> withConstrainedDepth(const RegistrationProblem& problem,
                                                   const RegistrationOptions& options, const MethodSolution& solution,
                                                   const RegistrationResult& judged);

}   // namespace angiopose::core
