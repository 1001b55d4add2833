#pragma once

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// The threshold that best separates values ≥ 0 into two classes (Otsu 1979), over 256 bins from 0 to the largest.
/// 0 when there is nothing to separate.
float otsuThreshold(const std::vector<float>& values);

/// Every n-th value, so that at most `most` are left: enough for statistics of a large image.
std::vector<float> evenSample(const std::vector<float>& values, std::size_t most);

/// The value that `share` (0…1) of the values do not exceed; `values` must not be empty. Linear time.
float ranked(std::vector<float> values, double share);

/// The same for several shares, ascending.
std::vector<float> rankedAt(std::vector<float> values, const std::vector<double>& shares);

}   // namespace angiopose::core