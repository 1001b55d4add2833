#include "core/tracing/tree/edge_takeoff.h"

#include "core/support/quantile.h"

#include <algorithm>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double lookAheadMm = 12.0;   ///< length over which width and direction of an edge are measured

}   // namespace

EdgeTakeoff measureTakeoff(const VesselEdge& edge, double nodeRadiusMm)
{
    const Eigen::Vector3d& start = edge.pointsMm.front();
    std::vector<double> radii;
    std::size_t last = edge.pointsMm.size() - 1;
    for (std::size_t i = 0; i < edge.pointsMm.size(); ++i) {
        const double away = (edge.pointsMm[i] - start).norm();
        if (away > nodeRadiusMm + lookAheadMm) {
            last = i;
            break;
        }
        if (away > nodeRadiusMm) {
            radii.push_back(edge.radiusMm[i]);
        }
    }
    EdgeTakeoff takeoff;
    takeoff.radiusMm = edge.radiusMm.back();
    if (!radii.empty()) {
        takeoff.radiusMm = medianOf(std::move(radii));
    }
    takeoff.direction = (edge.pointsMm[last] - start).normalized();
    return takeoff;
}

}   // namespace angiopose::core
