#include "core/registration/matching/curve_distance.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

double squaredDistanceToSegment(const Eigen::Vector2d& query, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    const Eigen::Vector2d along = to - from;
    const double squaredLength = along.squaredNorm();
    const double share = squaredLength > 0.0 ? std::clamp((query - from).dot(along) / squaredLength, 0.0, 1.0) : 0.0;
    return (query - from - share * along).squaredNorm();
}

}   // namespace

double distanceToCurve(const CurvePoints& curves, std::size_t nearest, const Eigen::Vector2d& query)
{
    const Eigen::Vector2d& point = curves.points[nearest];
    const int curve = curves.curveIndex[nearest];
    double squared = (query - point).squaredNorm();
    if (nearest > 0 && curves.curveIndex[nearest - 1] == curve) {
        squared = std::min(squared, squaredDistanceToSegment(query, curves.points[nearest - 1], point));
    }
    if (nearest + 1 < curves.points.size() && curves.curveIndex[nearest + 1] == curve) {
        squared = std::min(squared, squaredDistanceToSegment(query, point, curves.points[nearest + 1]));
    }
    return std::sqrt(squared);
}

}   // namespace angiopose::core