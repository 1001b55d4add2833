#pragma once

#include "core/simulation/contrast_path.h"
#include "core/simulation/grow_tree.h"

#include <vector>

namespace angiopose::core {

/// Opacified part of a tree and the other structures made visible by the contrast agent.
struct OpacifiedVessels {
    std::vector<ContrastPath> paths;   ///< opacified branches, extra vessels and the catheter
    std::vector<int> missingBranchIds;   ///< unopacified branches; their children are unopacified too
    VesselTree visible;   ///< opacified branches and extra vessels; extra vessels have ids above those of the tree
    VesselTree catheter;   ///< one branch; none if there is no catheter
    double maxPathMm = 0.0;
};

/// Randomly selects missing branches (thin ones twice as often), opacities, extra vessels and a catheter (ALGORITHMS
/// §4.4).
OpacifiedVessels opacifyVessels(const GrownTree& grown, const DsaOptions& options, CounterRandom& random);

}   // namespace angiopose::core
