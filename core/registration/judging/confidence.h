#pragma once

#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

struct ConfidenceAssessment {
    bool isTrustworthy = true;
    Messages warnings;   ///< reasons for low confidence, followed by the quantities that one view cannot determine
};

/// Returns the confidence with clinical reasons why a pose may be wrong; no messages if all checks pass. Requires the
/// metrics, uncertainty, stop reason and indicators of `result`.
ConfidenceAssessment assessConfidence(const RegistrationProblem& problem, const RegistrationResult& result);

}   // namespace angiopose::core
