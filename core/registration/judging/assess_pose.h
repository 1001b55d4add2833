#pragma once

#include "core/registration/problem/method_solution.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Returns the assessment of a pose: distances, branch residuals, uncertainty and confidence, but no method or history.
RegistrationResult assessPose(const RegistrationProblem& problem, const RegistrationOptions& options,
                              const MethodSolution& solution);

}   // namespace angiopose::core
