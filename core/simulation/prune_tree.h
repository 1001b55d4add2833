#pragma once

#include "core/support/random.h"
#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// Ids of the branches that end freely and that no other branch leaves: one bifurcation, one tip.
std::vector<int> leafBranchIds(const VesselTree& tree);

/// The tree without `count` random leaves (all of them when it has fewer).
VesselTree pruned(const VesselTree& tree, int count, CounterRandom& random);

}   // namespace angiopose::core