#pragma once

#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

struct Trust {
    bool isTrustworthy = true;
    Messages warnings;   ///< reasons against trust first, then what one view cannot tell
};

/// Says in a clinician's words why a pose may be wrong; silent when nothing speaks against it. Metrics, uncertainty,
/// stop reason and signs of `result` are filled in.
Trust judgeTrust(const RegistrationProblem& problem, const RegistrationResult& result);

}   // namespace angiopose::core
