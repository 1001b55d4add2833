#pragma once

#include "core/tracing/tree/vessel_graph.h"

#include <optional>
#include <vector>

namespace angiopose::core {

/// A vessel from where it leaves its parent to its end, over all the nodes it passes.
struct BranchPath {
    int parent = -1;   ///< index among the paths; -1: begins at a root
    int generation = 0;   ///< 0 for roots
    int endsOn = -1;   ///< index of the path that it ends on and closes a loop with, perhaps itself; -1: ends free
    std::vector<Eigen::Vector3d> pointsMm;   ///< the first lies at the node in the parent
    std::vector<double> radiusMm;
};

/// Which pieces of a graph become paths.
enum class PathPieces { First, All };

/// The graph as vessels from the root: at each node the vessel goes on in the edge that agrees best in
/// width and direction, the others leave it. Parents come before their children, the first generation first, along the
/// parent. The root of each piece is its end nearest to `rootMm`, or that of its thickest vessel; the piece with the
/// greatest length comes first. Thinning keeps pieces together, but the rim of the scan can cut them apart: only pieces
/// near one of `seedsMm` count, or without seeds the first or all. A vessel that comes back to one that was followed
/// before ends on it.
std::vector<BranchPath> branchPaths(const VesselGraph& graph, const std::optional<Eigen::Vector3d>& rootMm,
                                    const std::vector<Eigen::Vector3d>& seedsMm = {},
                                    PathPieces withoutSeeds = PathPieces::First);

}   // namespace angiopose::core