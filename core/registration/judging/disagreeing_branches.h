#pragma once

#include "core/registration/problem/registration_result.h"

#include <vector>

namespace angiopose::core {

/// Branches whose projection does not match the traced vessels at a pose.
struct DisagreeingBranches {
    std::vector<int> branchIds;   ///< in the tree's order
    double worstMm = 0.0;   ///< largest median of these branches, at the vessels
};

/// Branches with a median above 1 mm that the registration does not report as unopacified, that no deformation explains
/// and, if there is a wire, that lie on its path: they may still be unopacified, or have moved. A pose with such
/// branches may be correct and reliable.
DisagreeingBranches disagreeingBranches(const RegistrationResult& result, double millimetersPerPixel);

}   // namespace angiopose::core
