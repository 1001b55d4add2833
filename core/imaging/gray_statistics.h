#pragma once

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Returns the threshold that best separates values ≥ 0 into two classes (Otsu 1979), over 256 bins from 0 to the
/// maximum. Returns 0 if no value is positive.
float otsuThreshold(const std::vector<float>& values);

/// Returns every n-th value, with n chosen to give at most `most` values, for statistics of large images.
std::vector<float> subsample(const std::vector<float>& values, std::size_t maxCount);

/// Returns the quantile of `values` at the fraction `share` (0…1); `values` must not be empty. Runs in linear time.
float grayQuantile(std::vector<float> values, double fraction);

/// Returns the quantiles at several fractions in ascending order.
std::vector<float> grayQuantiles(std::vector<float> values, const std::vector<double>& fractions);

}   // namespace angiopose::core
