#pragma once

#include <vector>

namespace angiopose::core {

/// Returns the Spearman correlation of two lists of equal length, −1…1, over 256 bins of equal width whose members
/// share their mean rank; 0 if either list is constant (stochastic rank correlation: Birkfellner et al. 2009).
double rankCorrelation(const std::vector<float>& a, const std::vector<float>& b);

}   // namespace angiopose::core
