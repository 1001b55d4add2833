#pragma once

#include "core/registration/method.h"

namespace angiopose::core {

/// Least Huber loss of the distances to the nearest traced vessel, by damped steps with fresh matches; or least squared
/// distances by L-BFGS; with an affine stage on request (ALGORITHMS §3.6). Source: Rivest-Hénault et al. 2012.
MethodSolution solveDtIcp(const RegistrationProblem& problem, const RegistrationOptions& options,
                          ProgressLog& progress);

}   // namespace angiopose::core