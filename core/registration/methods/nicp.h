#pragma once

#include "core/registration/method.h"

namespace angiopose::core {

/// Gradient ascent of the mean kernel between projected tree and target, coarse to fine (ALGORITHMS §3.3), or of the
/// brightness at each vessel's own width (§3.4, option `nicpImage`). Source: Aylward et al. 2003; as Song and Ghaffari
/// describe it.
MethodSolution solveNicp(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress);

/// The same inside the alternating search (§3.5).
MethodSolution solveNicpAlternating(const RegistrationProblem& problem, const RegistrationOptions& options,
                                    ProgressLog& progress);

}   // namespace angiopose::core