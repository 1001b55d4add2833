#include "core/tracing/angiogram/curves/vessel_trunk.h"

#include "core/support/quantile.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double takeoffTolerancePx = 4.0;   // tolerance beyond the wall; tracing may stop short of a branch's origin
constexpr int minBranches = 2;

bool endsOn(const Eigen::Vector2d& endPx, const Curve2d& trunk)
{
    for (std::size_t i = 0; i < trunk.pointsPx.size(); ++i) {
        if ((trunk.pointsPx[i] - endPx).norm() <= trunk.radiusPx[i] + takeoffTolerancePx) {
            return true;
        }
    }
    return false;
}

bool hasBranches(const Curve2d& trunk, const Centerline2d& centerline)
{
    return std::ranges::count_if(centerline.curves, [&](const Curve2d& other) {
               return other.id != trunk.id && !other.pointsPx.empty() &&
                      (endsOn(other.pointsPx.front(), trunk) || endsOn(other.pointsPx.back(), trunk));
           }) >= minBranches;
}

}   // namespace

std::optional<int> findWidestTrunk(const Centerline2d& centerline)
{
    std::optional<int> trunk;
    double widestPx = 0.0;
    for (const Curve2d& curve : centerline.curves) {
        if (curve.pointsPx.empty() || curve.radiusPx.size() != curve.pointsPx.size()) {
            continue;
        }
        const double radiusPx = quantile(curve.radiusPx, 0.5);
        if (radiusPx > widestPx && hasBranches(curve, centerline)) {
            trunk = curve.id;
            widestPx = radiusPx;
        }
    }
    return trunk;
}

}   // namespace angiopose::core
