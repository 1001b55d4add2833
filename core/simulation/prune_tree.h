#pragma once

#include "core/support/random.h"
#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// Returns the ids of the leaf branches, which have one bifurcation and one free end.
std::vector<int> leafBranchIds(const VesselTree& tree);

/// Returns the tree without `count` random leaf branches, or without any if there are fewer.
VesselTree removeRandomLeaves(const VesselTree& tree, int count, CounterRandom& random);

}   // namespace angiopose::core
