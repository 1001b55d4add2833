#pragma once

#include <vector>

namespace angiopose::core {

struct Interval {
    double low = 0.0;
    double high = 1.0;
};

/// Returns Wilson's score interval of a proportion, 95 % by default (Wilson 1927); [0, 1] if `count` is zero.
Interval wilsonInterval(int successes, int count, double z = 1.959963984540054);

/// Returns the p values adjusted for multiple comparisons by Holm's method (Holm 1979), in input order.
std::vector<double> adjustByHolm(const std::vector<double>& pValues);

/// Number of successes and of trials for one tree.
struct ClusterCount {
    int successes = 0;
    int count = 0;
};

/// Returns the 95 % interval of a proportion when each tree is used in several trials: trees are resampled with all
/// their trials (bootstrap, percentiles of 2000 draws). The interval is never narrower than Wilson's, which is valid if
/// the trees do not differ. The result is deterministic.
Interval clusteredInterval(const std::vector<ClusterCount>& trees);

}   // namespace angiopose::core
