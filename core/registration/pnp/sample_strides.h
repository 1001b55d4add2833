#pragma once

#include "core/registration/problem/registration_problem.h"

#include <cstddef>

namespace angiopose::core {

/// Returns the stride at which the tree points, projected at the initial pose, are about `stepPx` apart; at least 1.
std::size_t treeStride(const RegistrationProblem& problem, double stepPx);

/// Returns the stride at which the target points are about `stepPx` apart; at least 1.
std::size_t targetStride(const TargetSamples& target, double stepPx);

}   // namespace angiopose::core
