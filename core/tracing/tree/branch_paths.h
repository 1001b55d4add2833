#pragma once

#include "core/tracing/tree/vessel_graph.h"

#include <optional>
#include <vector>

namespace angiopose::core {

/// A vessel from its origin on the parent to its end, over all nodes that it passes.
struct BranchPath {
    int parent = -1;   ///< index among the paths; -1: begins at a root
    int generation = 0;   ///< 0 for roots
    int endsOn = -1;   ///< path it ends on, closing a loop (perhaps itself); -1: free end
    std::vector<Eigen::Vector3d> pointsMm;   ///< the first point lies at the node in the parent
    std::vector<double> radiusMm;
};

/// Which connected components of a graph become paths.
enum class PathPieces { First, All };

/// Splits the graph into vessels, starting at the root: at each node the vessel continues in the edge that agrees best
/// in width and direction, and the other edges branch from it. Parents come before their children, the first generation
/// first, along the parent. The root of each component is its end nearest to `rootMm`, or that of its thickest vessel;
/// the component with the greatest length comes first. Thinning keeps components together, but the rim of the scan can
/// cut them apart: only components near one of `seedsMm` count, or without seeds the first or all. A vessel that
/// returns to an already followed vessel ends on it.
std::vector<BranchPath> branchPaths(const VesselGraph& graph, const std::optional<Eigen::Vector3d>& rootMm,
                                    const std::vector<Eigen::Vector3d>& seedsMm = {},
                                    PathPieces withoutSeeds = PathPieces::First);

}   // namespace angiopose::core