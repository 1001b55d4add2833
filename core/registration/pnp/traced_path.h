#pragma once

#include "core/registration/pnp/branch_graph.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Path along the traced vessels, leading away from a node.
struct TracedPath {
    static constexpr int nowhere = -1;

    std::vector<Eigen::Vector2d> points;   ///< px
    std::vector<int> edges;   ///< edges of the graph
    int arrivesAt = nowhere;   ///< final node, unless the path was cut short
    double lengthPx = 0.0;
};

/// Starts with `way` and continues straight through further nodes while the path is much shorter than `wantedPx`; cuts
/// it there if it is much longer. Contains at least one point.
TracedPath pathFrom(const BranchGraph& graph, const TargetSamples& target, EdgeEnd way, double wantedPx);

/// Point at arc length `alongPx` of a polyline; clamps to its ends.
Eigen::Vector2d placeAlong(const std::vector<Eigen::Vector2d>& points, double alongPx);

double lengthOf(const std::vector<Eigen::Vector2d>& points);

}   // namespace angiopose::core
