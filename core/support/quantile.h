#pragma once

#include <vector>

namespace angiopose::core {

/// Returns the quantile of `values` at `fraction` (0…1), interpolated linearly (R type 7); NaN without values.
double quantile(std::vector<double> values, double fraction);

/// Returns the quantiles at several fractions in one pass.
std::vector<double> quantiles(std::vector<double> values, const std::vector<double>& fractions);

/// Returns the median, or the upper of the two middle values for an even count; the result is always one of the values.
/// `values` must not be empty.
double medianOf(std::vector<double> values);

}   // namespace angiopose::core
