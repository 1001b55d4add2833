#pragma once

#include <vector>

namespace angiopose::core {

/// Wilcoxon's signed-rank test of paired differences (ALGORITHMS §4.6): zeros dropped, equal sizes share their mean
/// rank; exact up to 50 differences, beyond that normal with tie and continuity correction.
struct SignedRankTest {
    int count = 0;   ///< differences that are not zero
    double rankSum = 0.0;   ///< W: ranks of the positive differences ("ours minus theirs": where ours is worse)
    double pLess = 1.0;   ///< P(W or smaller) when neither side is better: one-sided, differences tend to be negative
    double pTwoSided = 1.0;
    double effectSize = 0.0;   ///< r = Φ⁻¹(1 − pLess)/√count, −1…1
};

/// Not finite differences are an error of the caller; infinities of one sign compare as the largest.
SignedRankTest signedRankTest(const std::vector<double>& differences);

/// Hodges–Lehmann estimate of the shift: median of the means of all pairs, each value with itself too. NaN when empty.
double hodgesLehmann(const std::vector<double>& differences);

/// x with P(standard normal ≤ x) = p, relative error below 1e-9, for 0 < p < 1.
double normalQuantile(double p);

}   // namespace angiopose::core