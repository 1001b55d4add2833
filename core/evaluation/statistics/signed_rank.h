#pragma once

#include <vector>

namespace angiopose::core {

/// Result of Wilcoxon's signed-rank test of paired differences (ALGORITHMS §4.6). Zeros are dropped and ties get their
/// mean rank. The test is exact for up to 50 differences; above that, it is a normal approximation with tie and
/// continuity correction.
struct SignedRankTest {
    int count = 0;   ///< number of nonzero differences
    double rankSum = 0.0;   ///< W: rank sum of the positive differences (in "ours minus theirs": ours is worse)
    double pLess = 1.0;   ///< P(W or smaller) if neither side is better; one-sided, small for negative differences
    double pTwoSided = 1.0;
    double effectSize = 0.0;   ///< r = Φ⁻¹(1 − pLess)/√count, in −1…1
};

/// Runs the test. Infinite differences of one sign get the largest ranks; NaN is not allowed.
SignedRankTest signedRankTest(const std::vector<double>& differences);

/// Returns the Hodges–Lehmann estimate of the shift: the median of the means of all pairs, including each value paired
/// with itself; NaN if there are no differences.
double hodgesLehmann(const std::vector<double>& differences);

/// Returns x with P(standard normal ≤ x) = p, with relative error below 1e-9, for 0 < p < 1.
double normalQuantile(double p);

}   // namespace angiopose::core
