#pragma once

#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Indices of the tree points {p'} of the auxiliary problem in the alternating search, ascending, according to option
/// `auxiliary`. Random points depend on `randomSeed`. `branchIds` are the branches the user chose.
std::vector<int> auxiliaryPoints(const TreeSamples& tree, const std::vector<int>& branchIds,
                                 const RegistrationOptions& options);

}   // namespace angiopose::core
