#pragma once

#include "core/registration/methods/method.h"

namespace angiopose::core {

/// Everything a result says about a pose: distances, branches, uncertainty, trust. Touches neither method nor history.
RegistrationResult judgePose(const RegistrationProblem& problem, const RegistrationOptions& options,
                             const MethodSolution& solution);

}   // namespace angiopose::core