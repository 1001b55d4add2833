#pragma once

#include "core/registration/pnp/branch_graph.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// A way along the traced vessels, away from a node.
struct TracedPath {
    static constexpr int nowhere = -1;

    std::vector<Eigen::Vector2d> points;   ///< px
    std::vector<int> edges;   ///< of the graph
    int arrivesAt = nowhere;   ///< node, unless it was cut short
    double lengthPx = 0.0;
};

/// Leaves by `way` and goes straight on through further nodes while it is much shorter than `wantedPx`; cut there where
/// it is much longer. At least one point.
TracedPath pathFrom(const BranchGraph& graph, const TargetSamples& target, EdgeEnd way, double wantedPx);

/// The place that lies `alongPx` along a polyline; its ends before and after.
Eigen::Vector2d placeAlong(const std::vector<Eigen::Vector2d>& points, double alongPx);

double lengthOf(const std::vector<Eigen::Vector2d>& points);

}   // namespace angiopose::core
