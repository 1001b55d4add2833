#include "core/tracing/tree/departure.h"

#include "core/support/quantile.h"

#include <algorithm>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double lookAheadMm = 12.0;   ///< length over which width and direction of an edge are measured

}   // namespace

Departure departureOf(const VesselEdge& edge, double nodeRadiusMm)
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
    Departure departure;
    departure.radiusMm = edge.radiusMm.back();
    if (!radii.empty()) {
        departure.radiusMm = medianOf(std::move(radii));
    }
    departure.direction = (edge.pointsMm[last] - start).normalized();
    return departure;
}

}   // namespace angiopose::core
