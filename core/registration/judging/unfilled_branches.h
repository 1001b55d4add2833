#pragma once

#include "core/registration/problem/registration_problem.h"

#include <cstdint>

namespace angiopose::core {

/// Branches of which more than half of the part inside the image is unopacified. Takes one flag per tree point.
std::vector<UnopacifiedBranch> unopacifiedBranches(const TreeSamples& tree,
                                                   const std::vector<std::uint8_t>& isOpacified,
                                                   const std::vector<std::uint8_t>& isInView);

/// Opacified fraction of the tree points, 0…1.
double shareFilled(const std::vector<std::uint8_t>& isOpacified);

/// Fraction of the tree to which the distances of a result refer, 0…1; the rest is considered unopacified.
double judgedShare(const RegistrationResult& result);

/// Returns messages that name the unopacified branches if they are few; empty if there are none.
Messages wordsOf(const std::vector<UnopacifiedBranch>& unopacified, double filledShare, std::size_t branchCount);

}   // namespace angiopose::core
