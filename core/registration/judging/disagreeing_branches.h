#pragma once

#include "core/registration/problem/registration_result.h"

#include <vector>

namespace angiopose::core {

/// Branches that the traced vessels do not show where a pose puts them.
struct DisagreeingBranches {
    std::vector<int> branchIds;   ///< in the tree's order
    double worstMm = 0.0;   ///< largest median of one of them, at the vessels
};

/// Those with a median above 1 mm that the run does not call unfilled, that no bend explains and that lie on the way of
/// a wire, where there is one: perhaps unfilled all the same, or moved. A pose may be right beside them, and trusted.
DisagreeingBranches disagreeingBranches(const RegistrationResult& result, double millimetersPerPixel);

}   // namespace angiopose::core
