#pragma once

#include "core/registration/problem/registration_problem.h"

#include <cstddef>

namespace angiopose::core {

/// Stride of tree points whose projections at the initial pose are about `wantedPx` apart; at least 1.
std::size_t treeStride(const RegistrationProblem& problem, double wantedPx);

/// Same for the traced vessels.
std::size_t targetStride(const TargetSamples& target, double wantedPx);

}   // namespace angiopose::core
