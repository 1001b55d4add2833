#pragma once

#include "core/registration/problem/registration_problem.h"

#include <cstdint>

namespace angiopose::core {

/// Returns the branches more than half unopacified inside the image. Takes one flag per tree point.
std::vector<UnopacifiedBranch> unopacifiedBranches(const TreeSamples& tree,
                                                   const std::vector<std::uint8_t>& isOpacified,
                                                   const std::vector<std::uint8_t>& isInView);

/// Opacified fraction of the tree points, 0…1.
double opacifiedShare(const std::vector<std::uint8_t>& isOpacified);

/// Fraction of the tree to which the distances of a result refer, 0…1; the rest is considered unopacified.
double assessedShare(const RegistrationResult& result);

/// Returns messages about the unopacified branches, naming the branches if there are only a few.
Messages unopacifiedMessages(const std::vector<UnopacifiedBranch>& unopacified, double opacifiedFraction,
                             std::size_t branchCount);

}   // namespace angiopose::core
