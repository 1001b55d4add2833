#pragma once

#include "core/registration/method.h"

namespace angiopose::core {

/// Least L2 distance between mixtures of oriented Gaussians of projected tree and traced vessels, coarse to fine, by
/// L-BFGS (ALGORITHMS §3.12). Source: Baka et al. 2014.
MethodSolution solveOgmm(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress);

}   // namespace angiopose::core