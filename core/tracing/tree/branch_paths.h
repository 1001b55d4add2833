#pragma once

#include "core/tracing/tree/vessel_graph.h"

#include <optional>
#include <vector>

namespace angiopose::core {

/// Vessel from its origin on the parent to its end, across all nodes in between.
struct BranchPath {
    int parent = -1;   ///< index of the parent path; -1 for paths from a root
    int generation = 0;   ///< 0 for roots
    int loopTarget = -1;   ///< path that this one joins to close a loop (possibly itself); -1 for a free end
    std::vector<Eigen::Vector3d> pointsMm;   ///< the first point is the node on the parent
    std::vector<double> radiusMm;
};

/// Connected components of a graph to convert to paths.
enum class PathComponents { First, All };

/// Splits the graph into vessels, starting at the root: at each node, the vessel continues along the edge that best
/// matches its width and direction, and the other edges become its branches. Parents precede their children, generation
/// by generation, in order along the parent. The root of each component is the end nearest to `rootMm`, or the end of
/// the thickest vessel; the longest component comes first. Thinning preserves connectivity, but the scan boundary can
/// cut a tree into components: only components near one of `seedsMm` are used, or without seeds the first one or all. A
/// vessel that reaches an already traced vessel ends there.
std::vector<BranchPath> splitIntoPaths(const VesselGraph& graph, const std::optional<Eigen::Vector3d>& rootMm,
                                       const std::vector<Eigen::Vector3d>& seedsMm = {},
                                       PathComponents withoutSeeds = PathComponents::First);

}   // namespace angiopose::core
