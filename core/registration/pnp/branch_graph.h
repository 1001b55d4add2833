#pragma once

#include "core/registration/problem/registration_problem.h"

#include <array>
#include <cstddef>
#include <vector>

namespace angiopose::core {

/// A stretch of a vessel between two nodes: points [from, to) of the samples it was made of.
struct BranchEdge {
    int curve = 0;   ///< branch or traced curve it belongs to
    std::size_t from = 0;
    std::size_t to = 0;
    std::array<int, 2> nodes{};   ///< at its first and its last point

    std::size_t size() const { return to - from; }
};

/// An edge as one leaves a node.
struct EdgeEnd {
    int edge = 0;
    bool isReversed = false;   ///< it is walked from its last point to its first
};

/// Vessels cut wherever one leaves another, and what meets where: ends within reach of each other are one node. Rings
/// stay rings.
struct BranchGraph {
    std::vector<BranchEdge> edges;   ///< in the order of the samples
    std::vector<std::vector<EdgeEnd>> nodes;   ///< the ends that meet at each, ascending by edge

    /// The node at which a walk along the edge arrives.
    int arrivalOf(const EdgeEnd& way) const
    {
        return edges[static_cast<std::size_t>(way.edge)].nodes[way.isReversed ? 0 : 1];
    }
};

/// Branches meet within 2.5 mm.
BranchGraph graphOf(const TreeSamples& tree);

/// Traced curves meet within 5 px; those that cross without an end there do not.
BranchGraph graphOf(const TargetSamples& target);

}   // namespace angiopose::core
