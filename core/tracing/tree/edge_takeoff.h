#pragma once

#include "core/tracing/tree/vessel_graph.h"

#include <Eigen/Core>

namespace angiopose::core {

/// Width and direction of an edge at its start node, measured outside the sphere inscribed there.
struct EdgeTakeoff {
    double radiusMm = 0.0;
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
};

EdgeTakeoff measureTakeoff(const VesselEdge& edge, double nodeRadiusMm);

}   // namespace angiopose::core
