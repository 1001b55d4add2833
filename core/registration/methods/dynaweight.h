#pragma once

#include "core/registration/method.h"

namespace angiopose::core {

/// DynaWeightPnP, ALGORITHMS §3.2: a turn about the source, then auxiliary points with held matches and all points with
/// fresh ones take turns.
MethodSolution solveDynaWeight(const RegistrationProblem& problem, const RegistrationOptions& options,
                               ProgressLog& progress);

}   // namespace angiopose::core