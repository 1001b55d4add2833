#pragma once

#include "core/simulation/contrast_path.h"
#include "core/simulation/grow_tree.h"

#include <vector>

namespace angiopose::core {

/// Which part of a tree the contrast medium shows, and what it shows besides.
struct FilledVessels {
    std::vector<ContrastPath> paths;   ///< filled branches, extra vessels, catheter
    std::vector<int> missingBranchIds;   ///< not filled, and none of their children is
    VesselTree visible;   ///< filled branches and extra vessels; these have ids above the tree's
    VesselTree catheter;   ///< one branch, or none
    double longestPathMm = 0.0;
};

/// Chooses missing branches (thin ones twice as often), opacities, extra vessels and the catheter (ALGORITHMS §4.4).
FilledVessels fillVessels(const GrownTree& grown, const DsaOptions& options, CounterRandom& random);

}   // namespace angiopose::core