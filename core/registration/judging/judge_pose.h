#pragma once

#include "core/registration/problem/method_solution.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Everything a result says about a pose: distances, branches, uncertainty, trust. Touches neither method nor history.
RegistrationResult judgePose(const RegistrationProblem& problem, const RegistrationOptions& options,
                             const MethodSolution& solution);

}   // namespace angiopose::core