#pragma once

#include "core/registration/problem/registration_problem.h"

#include <cstdint>

namespace angiopose::core {

/// Branches of which more than half of the part inside the image is unopacified. Takes one flag per tree point.
std::vector<UnopacifiedBranch> unopacifiedBranches(const TreeSamples& tree,
                                                   const std::vector<std::uint8_t>& isOpacified,
                                                   const std::vector<std::uint8_t>& isInView);

/// Opacified share of the tree's points, 0…1.
double shareFilled(const std::vector<std::uint8_t>& isOpacified);

/// Share of the tree that the distances of a result cover, 0…1; the rest is considered unopacified.
double judgedShare(const RegistrationResult& result);

/// Names the unopacified branches if they are few; empty when there are none.
Messages wordsOf(const std::vector<UnopacifiedBranch>& unopacified, double filledShare, std::size_t branchCount);

}   // namespace angiopose::core
