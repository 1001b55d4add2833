#pragma once

#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Numbers of the tree points {p'} that the alternating search solves by themselves, ascending, by option `auxiliary`.
/// Random points follow from `randomSeed`. `branchIds` are those the user chose.
std::vector<int> auxiliaryPoints(const TreeSamples& tree, const std::vector<int>& branchIds,
                                 const RegistrationOptions& options);

}   // namespace angiopose::core