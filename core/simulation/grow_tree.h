#pragma once

#include "core/simulation/simulated_case.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Where a branch leaves its parent; both indices into the tree that holds them.
struct Takeoff {
    int parentIndex = -1;   ///< -1: the trunk
    std::size_t parentPoint = 0;
};

/// A generated tree that still knows who leaves whom, one takeoff per branch; parents come before their children.
struct GrownTree {
    VesselTree tree;
    std::vector<Takeoff> takeoffs;
};

/// Grows a trunk, then lets branch after branch reach for the emptiest part of an ellipsoid; radii follow Murray's law.
GrownTree growTree(std::uint64_t seed, const TreeOptions& options);

}   // namespace angiopose::core