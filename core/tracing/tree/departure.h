#pragma once

#include "core/tracing/tree/vessel_graph.h"

#include <Eigen/Core>

namespace angiopose::core {

/// Width and direction of an edge where it leaves its start node, outside the node's own ball.
struct Departure {
    double radiusMm = 0.0;
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
};

Departure departureOf(const VesselEdge& edge, double nodeRadiusMm);

}   // namespace angiopose::core