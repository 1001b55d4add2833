#pragma once

#include <vector>

namespace angiopose::core {

struct Interval {
    double low = 0.0;
    double high = 1.0;
};

/// Wilson's score interval of a share, 95 % by default (Wilson 1927); [0, 1] when nothing was counted.
Interval wilsonInterval(int successes, int count, double z = 1.959963984540054);

/// Holm's adjustment of p values for as many comparisons as there are values (Holm 1979), in their order.
std::vector<double> holmAdjusted(const std::vector<double>& pValues);

/// What was counted in one tree.
struct ClusterCount {
    int successes = 0;
    int count = 0;
};

/// 95 % interval of a share whose trials share trees: trees are drawn anew with all their trials (bootstrap,
/// percentiles of 2000 draws), and it is never narrower than Wilson's, which holds where the trees do not differ. The
/// same for the same counts.
Interval clusteredInterval(const std::vector<ClusterCount>& trees);

}   // namespace angiopose::core
