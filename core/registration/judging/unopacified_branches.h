#pragma once

#include "core/registration/problem/registration_problem.h"

#include <cstdint>

namespace angiopose::core {

/// Returns the branches of which more than half is unopacified inside the image, given one flag per tree point.
std::vector<UnopacifiedBranch> unopacifiedBranches(const TreeSamples& tree,
                                                   const std::vector<std::uint8_t>& isOpacified,
                                                   const std::vector<std::uint8_t>& isInView);

/// Returns the opacified fraction of the tree points, 0…1.
double opacifiedLengthFraction(const std::vector<std::uint8_t>& isOpacified);

/// Returns the fraction of the tree to which the distances of a result refer, 0…1; the rest is considered unopacified.
double assessedFraction(const RegistrationResult& result);

/// Returns messages about the unopacified branches; if there are only a few, the messages name them.
Messages unopacifiedMessages(const std::vector<UnopacifiedBranch>& unopacified, double opacifiedFraction,
                             std::size_t branchCount);

}   // namespace angiopose::core
