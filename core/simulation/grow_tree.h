#pragma once

#include "core/simulation/simulated_case.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Position where a branch leaves its parent, given by the indices of the parent branch and of its point.
struct Takeoff {
    int parentIndex = -1;   ///< -1 for the trunk
    std::size_t parentPoint = 0;
};

/// A generated tree with its hierarchy: one takeoff per branch; parents come before their children.
struct GrownTree {
    VesselTree tree;
    std::vector<Takeoff> takeoffs;
};

/// Grows a trunk, then adds branch after branch toward the emptiest part of an ellipsoid; radii follow Murray's law.
GrownTree growTree(std::uint64_t seed, const TreeOptions& options);

}   // namespace angiopose::core
