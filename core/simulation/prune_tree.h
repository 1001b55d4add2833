#pragma once

#include "core/support/random.h"
#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// Returns the ids of leaf branches, which have a free end and no child branch: one bifurcation, one tip.
std::vector<int> leafBranchIds(const VesselTree& tree);

/// Returns the tree without `count` random leaves (without all of them if it has fewer).
VesselTree pruned(const VesselTree& tree, int count, CounterRandom& random);

}   // namespace angiopose::core