#pragma once

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Returns the threshold that best separates values ≥ 0 into two classes (Otsu 1979), over 256 bins from 0 to the
/// maximum. 0 if there is nothing to separate.
float otsuThreshold(const std::vector<float>& values);

/// Returns every n-th value, at most `most` of them: enough for statistics of a large image.
std::vector<float> evenSample(const std::vector<float>& values, std::size_t most);

/// Returns the quantile that `share` (0…1) of the values do not exceed; `values` must not be empty. Linear time.
float ranked(std::vector<float> values, double share);

/// Same for several shares, in ascending order.
std::vector<float> rankedAt(std::vector<float> values, const std::vector<double>& shares);

}   // namespace angiopose::core