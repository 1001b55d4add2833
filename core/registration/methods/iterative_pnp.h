#pragma once

#include "core/registration/method.h"

namespace angiopose::core {

/// DynaWeightPnP*, ALGORITHMS §3.1: kernel PnP with all points from the start pose.
MethodSolution solveIterativePnp(const RegistrationProblem& problem, const RegistrationOptions& options,
                                 ProgressLog& progress);

}   // namespace angiopose::core