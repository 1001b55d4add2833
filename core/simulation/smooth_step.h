#pragma once

#include <algorithm>

namespace angiopose::core {

/// Returns 0 below 0, 1 above 1, and a cubic with zero end slopes in between.
inline double smoothStep(double t)
{
    const double x = std::clamp(t, 0.0, 1.0);
    return x * x * (3.0 - 2.0 * x);
}

}   // namespace angiopose::core