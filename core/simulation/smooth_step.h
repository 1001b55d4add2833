#pragma once

#include <algorithm>

namespace angiopose::core {

/// Returns 0 for t below 0 and 1 for t above 1; in between, a cubic with zero slope at both ends.
inline double smoothStep(double t)
{
    const double x = std::clamp(t, 0.0, 1.0);
    return x * x * (3.0 - 2.0 * x);
}

}   // namespace angiopose::core
