#pragma once

#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Returns the ascending indices of the tree points {p'} of the auxiliary problem in the alternating search, according
/// to option `auxiliary`. Random points depend on option `randomSeed`. `branchIds` are the branches the user chose.
std::vector<int> auxiliaryPoints(const TreeSamples& tree, const std::vector<int>& branchIds,
                                 const RegistrationOptions& options);

}   // namespace angiopose::core
