#include "core/tracing/angiogram/curves/rasterize_vessels.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

/// Segment of a vessel between two points of its curve.
struct VesselSegment {
    Eigen::Vector2d startPx;
    Eigen::Vector2d alongPx;
    double startRadiusPx = 0.0;
    double radiusChange = 0.0;   ///< radius at the end minus radius at the start

    bool contains(const Eigen::Vector2d& pixel) const
    {
        const double squaredLength = alongPx.squaredNorm();
        const double at =
            squaredLength > 0.0 ? std::clamp((pixel - startPx).dot(alongPx) / squaredLength, 0.0, 1.0) : 0.0;
        return (pixel - startPx - at * alongPx).norm() <= startRadiusPx + at * radiusChange;
    }
};

void rasterizeSegment(Mask2d& mask, const VesselSegment& segment)
{
    const double reach = segment.startRadiusPx + std::max(0.0, segment.radiusChange);
    const Eigen::Vector2d end = segment.startPx + segment.alongPx;
    const Eigen::Vector2d low = (segment.startPx.cwiseMin(end).array() - reach).matrix();
    const Eigen::Vector2d high = (segment.startPx.cwiseMax(end).array() + reach).matrix();
    const int lastX = std::min(mask.width - 1, static_cast<int>(std::floor(high.x())));
    const int lastY = std::min(mask.height - 1, static_cast<int>(std::floor(high.y())));
    for (int y = std::max(0, static_cast<int>(std::ceil(low.y()))); y <= lastY; ++y) {
        for (int x = std::max(0, static_cast<int>(std::ceil(low.x()))); x <= lastX; ++x) {
            if (segment.contains({x, y})) {
                mask.at(x, y) = 255;
            }
        }
    }
}

}   // namespace

Mask2d rasterizeVessels(const Centerline2d& centerline, int width, int height)
{
    Mask2d mask(width, height);
    for (const Curve2d& curve : centerline.curves) {
        for (std::size_t i = 1; i < std::min(curve.pointsPx.size(), curve.radiusPx.size()); ++i) {
            rasterizeSegment(mask, {curve.pointsPx[i - 1], curve.pointsPx[i] - curve.pointsPx[i - 1],
                                    curve.radiusPx[i - 1], curve.radiusPx[i] - curve.radiusPx[i - 1]});
        }
    }
    return mask;
}

}   // namespace angiopose::core
