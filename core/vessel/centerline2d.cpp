#include "core/vessel/centerline2d.h"

#include "core/messages/messages.h"
#include "core/vessel/polyline.h"

namespace angiopose::core {

double Curve2d::lengthPx() const
{
    return polylineLength(pointsPx);
}

std::size_t Centerline2d::pointCount() const
{
    std::size_t count = 0;
    for (const Curve2d& curve : curves) {
        count += curve.pointsPx.size();
    }
    return count;
}

std::vector<Eigen::Vector2d> tangentsOf(const std::vector<Eigen::Vector2d>& points, int reach)
{
    return polylineTangents(points, static_cast<std::size_t>(reach));
}

Centerline2d resampled(const Centerline2d& centerline, double spacingPx)
{
    Centerline2d result;
    for (const Curve2d& curve : centerline.curves) {
        const std::vector<PolylineStation> stations = evenStations(curve.pointsPx, spacingPx);
        Curve2d even{curve.id, interpolate(curve.pointsPx, stations), {}};
        if (curve.radiusPx.size() == curve.pointsPx.size()) {
            even.radiusPx = interpolate(curve.radiusPx, stations);
        }
        result.curves.push_back(std::move(even));
    }
    return result;
}

std::optional<Message> findProblem(const Centerline2d& centerline)
{
    if (centerline.pointCount() == 0) {
        return messages::centerlineEmpty();
    }
    for (const Curve2d& curve : centerline.curves) {
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            if (!point.allFinite()) {
                return messages::curveNotFinite(curve.id);
            }
        }
    }
    return {};
}

}   // namespace angiopose::core
