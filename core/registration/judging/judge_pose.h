#pragma once

#include "core/registration/problem/method_solution.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Computes all parts of a result that describe a pose: distances, branches, uncertainty, confidence. Leaves method and
/// history unchanged.
RegistrationResult judgePose(const RegistrationProblem& problem, const RegistrationOptions& options,
                             const MethodSolution& solution);

}   // namespace angiopose::core