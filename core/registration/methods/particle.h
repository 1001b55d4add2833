#pragma once

#include "core/registration/method.h"

namespace angiopose::core {

/// Searches by many poses at once (ALGORITHMS §3.13): an annealed particle filter around the start, or a walk over the
/// two out-of-plane angles with the rest solved in each cell (after Tian et al. 2022). The best three are refined.
MethodSolution solveParticle(const RegistrationProblem& problem, const RegistrationOptions& options,
                             ProgressLog& progress);

}   // namespace angiopose::core