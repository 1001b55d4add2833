#pragma once

#include "core/registration/problem/method_solution.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// The solution with the depth of the start, refined there: for a depth that `judged` says the image does not tell
/// (ALGORITHMS §6.19). Nothing where the image tells it, or where it stayed.
std::optional<MethodSolution> withDepthHeld(const RegistrationProblem& problem, const RegistrationOptions& options,
                                            const MethodSolution& solution, const RegistrationResult& judged);

}   // namespace angiopose::core
