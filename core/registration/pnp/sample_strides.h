#pragma once

#include "core/registration/problem/registration_problem.h"

#include <cstddef>

namespace angiopose::core {

/// Steps between tree points so that their projections from the start pose lie about `wantedPx` apart; at least 1.
std::size_t treeStride(const RegistrationProblem& problem, double wantedPx);

/// The same for the traced vessels.
std::size_t targetStride(const TargetSamples& target, double wantedPx);

}   // namespace angiopose::core
