#pragma once

#include "core/evaluation/statistics/proportion.h"

#include <vector>

namespace angiopose::core {

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
