#pragma once

#include "core/registration/problem/registration_problem.h"

#include <cstdint>

namespace angiopose::core {

/// Branches of which more than half, as far as it lies inside the image, is not filled. One flag for each tree point.
std::vector<UnopacifiedBranch> unopacifiedBranches(const TreeSamples& tree,
                                                   const std::vector<std::uint8_t>& isOpacified,
                                                   const std::vector<std::uint8_t>& isInView);

/// Share of the tree's points, 0…1.
double shareFilled(const std::vector<std::uint8_t>& isOpacified);

/// Share of the tree that the distances of a result are about, 0…1: the rest is judged unopacified.
double judgedShare(const RegistrationResult& result);

/// Names them while they are few; nothing when there are none.
Messages wordsOf(const std::vector<UnopacifiedBranch>& unopacified, double filledShare, std::size_t branchCount);

}   // namespace angiopose::core
