#pragma once

#include <vector>

namespace angiopose::core {

struct Interval {
    double low = 0.0;
    double high = 1.0;
};

/// Returns Wilson's score interval of a proportion, 95 % by default (Wilson 1927); [0, 1] if nothing was counted.
Interval wilsonInterval(int successes, int count, double z = 1.959963984540054);

/// Returns the p values adjusted for multiple comparisons by Holm's method (Holm 1979), in input order.
std::vector<double> holmAdjusted(const std::vector<double>& pValues);

/// Successes and trials of one tree.
struct ClusterCount {
    int successes = 0;
    int count = 0;
};

/// Returns the 95 % interval of a proportion when several trials use one tree: trees are resampled with all their
/// trials (bootstrap, percentiles of 2000 draws). It is never narrower than Wilson's interval, which is valid if the
/// trees do not differ. Deterministic for equal counts.
Interval clusteredInterval(const std::vector<ClusterCount>& trees);

}   // namespace angiopose::core
