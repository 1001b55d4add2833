#pragma once

#include "core/registration/problem/registration_problem.h"

#include <array>
#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Vessel segment between two nodes: points [from, to) of the underlying samples.
struct BranchEdge {
    int curve = 0;   ///< index of the branch or traced curve
    std::size_t from = 0;
    std::size_t to = 0;
    std::array<int, 2> nodes{};   ///< nodes at its first and last point

    std::size_t size() const { return to - from; }
};

/// Edge with the direction in which it leaves a node.
struct EdgeEnd {
    int edge = 0;
    bool isReversed = false;   ///< whether the edge is traversed from its last point to its first
};

/// Graph of the vessels, cut wherever one branches off another; ends within touching distance of each other form one
/// node. Rings are kept.
struct BranchGraph {
    std::vector<BranchEdge> edges;   ///< in the order of the samples
    std::vector<std::vector<EdgeEnd>> nodes;   ///< edge ends at each node, in ascending order of the edge

    /// Returns the node reached by following the edge.
    int targetNode(const EdgeEnd& way) const
    {
        return edges[static_cast<std::size_t>(way.edge)].nodes[way.isReversed ? 0 : 1];
    }
};

/// Returns the graph of a tree, whose branches meet within 2.5 mm.
BranchGraph graphOf(const TreeSamples& tree);

/// Returns the graph of traced curves, which meet within 5 px; they do not meet where they cross without an end.
BranchGraph graphOf(const TargetSamples& target);

}   // namespace angiopose::core
