#pragma once

#include <vector>

namespace angiopose::core {

/// Upper edges of the bins of initial mTRE, mm: 1, 2, … 20, then 25, 30, … 100 (ALGORITHMS §4.5).
const std::vector<double>& captureBinEdgesMm();

}   // namespace angiopose::core