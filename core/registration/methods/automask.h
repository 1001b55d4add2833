#pragma once

#include "core/registration/method.h"

namespace angiopose::core {

/// Compares radiographs of the CTA's vessels, or of tubes, with the image by stochastic rank correlation inside a mask
/// around them; Nelder–Mead (ALGORITHMS §3.7). Source: Steininger et al. 2012.
MethodSolution solveAutoMask(const RegistrationProblem& problem, const RegistrationOptions& options,
                             ProgressLog& progress);

}   // namespace angiopose::core