#include "core/tracing/angiogram/curves/painted_vessels.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

/// Segment of a vessel between two points of its curve.
struct VesselPiece {
    Eigen::Vector2d startPx;
    Eigen::Vector2d alongPx;
    double startRadiusPx = 0.0;
    double widening = 0.0;   ///< radius at the end minus radius at the start

    bool holds(const Eigen::Vector2d& pixel) const
    {
        const double squaredLength = alongPx.squaredNorm();
        const double at =
            squaredLength > 0.0 ? std::clamp((pixel - startPx).dot(alongPx) / squaredLength, 0.0, 1.0) : 0.0;
        return (pixel - startPx - at * alongPx).norm() <= startRadiusPx + at * widening;
    }
};

void paintPiece(Mask2d& mask, const VesselPiece& piece)
{
    const double reach = piece.startRadiusPx + std::max(0.0, piece.widening);
    const Eigen::Vector2d end = piece.startPx + piece.alongPx;
    const Eigen::Vector2d low = (piece.startPx.cwiseMin(end).array() - reach).matrix();
    const Eigen::Vector2d high = (piece.startPx.cwiseMax(end).array() + reach).matrix();
    const int lastX = std::min(mask.width - 1, static_cast<int>(std::floor(high.x())));
    const int lastY = std::min(mask.height - 1, static_cast<int>(std::floor(high.y())));
    for (int y = std::max(0, static_cast<int>(std::ceil(low.y()))); y <= lastY; ++y) {
        for (int x = std::max(0, static_cast<int>(std::ceil(low.x()))); x <= lastX; ++x) {
            if (piece.holds({x, y})) {
                mask.at(x, y) = 255;
            }
        }
    }
}

}   // namespace

Mask2d paintedVessels(const Centerline2d& centerline, int width, int height)
{
    Mask2d mask(width, height);
    for (const Curve2d& curve : centerline.curves) {
        for (std::size_t i = 1; i < std::min(curve.pointsPx.size(), curve.radiusPx.size()); ++i) {
            paintPiece(mask, {curve.pointsPx[i - 1], curve.pointsPx[i] - curve.pointsPx[i - 1], curve.radiusPx[i - 1],
                              curve.radiusPx[i] - curve.radiusPx[i - 1]});
        }
    }
    return mask;
}

}   // namespace angiopose::core
