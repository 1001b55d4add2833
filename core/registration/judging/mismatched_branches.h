#pragma once

#include "core/registration/problem/registration_result.h"

#include <vector>

namespace angiopose::core {

/// Branches whose projection does not match the traced vessels at a pose.
struct MismatchedBranches {
    std::vector<int> branchIds;   ///< in the tree's order
    double maxDistanceMm = 0.0;   ///< largest median distance of these branches, at the depth of the vessels
};

/// Returns the branches with a median distance above 1 mm, except those reported as unopacified, explained by
/// deformation or, for a wire, off its path. They may nevertheless be unopacified or have moved, and the pose may still
/// be correct and reliable.
MismatchedBranches mismatchedBranches(const RegistrationResult& result, double millimetersPerPixel);

}   // namespace angiopose::core
