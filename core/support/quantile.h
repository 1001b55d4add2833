#pragma once

#include <vector>

namespace angiopose::core {

/// Returns the value below which `fraction` (0…1) of the values lie, interpolated linearly between neighbors (R type
/// 7); NaN without values.
double quantile(std::vector<double> values, double fraction);

/// Same for several fractions in one pass.
std::vector<double> quantiles(std::vector<double> values, const std::vector<double>& fractions);

/// Returns the middle value, the upper one for an even count, which is always one of the values. `values` must not be
/// empty.
double medianOf(std::vector<double> values);

}   // namespace angiopose::core