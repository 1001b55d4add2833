#pragma once

#include "core/registration/problem/method_solution.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Assesses a pose: computes distances, residuals per branch, uncertainty and confidence. Leaves method and history
/// unset.
RegistrationResult assessPose(const RegistrationProblem& problem, const RegistrationOptions& options,
                              const MethodSolution& solution);

}   // namespace angiopose::core
