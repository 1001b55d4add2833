#pragma once

#include "core/registration/pnp/branch_graph.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Path along the traced vessels that starts at a node.
struct TracedPath {
    static constexpr int noNode = -1;

    std::vector<Eigen::Vector2d> points;   ///< px
    std::vector<int> edges;   ///< indices of the graph's edges along the path
    int endNode = noNode;   ///< final node; `noNode` if the path was cut short
    double lengthPx = 0.0;
};

/// Follows `way` and continues straight through further nodes while the path is much shorter than `maxLengthPx`; cuts
/// the path at that length if it is much longer. The path contains at least one point.
TracedPath followPath(const BranchGraph& graph, const TargetSamples& target, EdgeEnd way, double maxLengthPx);

/// Returns the point at arc length `alongPx` of a polyline, clamped to its ends.
Eigen::Vector2d pointAtLength(const std::vector<Eigen::Vector2d>& points, double alongPx);

double lengthOf(const std::vector<Eigen::Vector2d>& points);

}   // namespace angiopose::core
