#include "tests/support/centerline_dice.h"

#include "core/tracing/angiogram/curves/thin_mask.h"

#include <algorithm>
#include <cmath>

namespace angiopose::test {
namespace {

constexpr double minPaintedRadiusPx = 1.5;

/// Marks the pixels within `radius` of a point; for a radius of 0, only the pixel containing it.
void paint(core::Mask2d& mask, const Eigen::Vector2d& point, double radius)
{
    const int reach = static_cast<int>(std::ceil(radius));
    const int x0 = static_cast<int>(std::lround(point.x()));
    const int y0 = static_cast<int>(std::lround(point.y()));
    for (int y = y0 - reach; y <= y0 + reach; ++y) {
        for (int x = x0 - reach; x <= x0 + reach; ++x) {
            const bool isNear = reach == 0 || (Eigen::Vector2d(x, y) - point).norm() <= radius;
            if (mask.contains(x, y) && isNear) {
                mask.at(x, y) = 255;
            }
        }
    }
}

double shareInside(const core::Mask2d& lines, const core::Mask2d& areas)
{
    double all = 0.0;
    double inside = 0.0;
    for (std::size_t i = 0; i < lines.pixels.size(); ++i) {
        all += lines.pixels[i] != 0 ? 1.0 : 0.0;
        inside += lines.pixels[i] != 0 && areas.pixels[i] != 0 ? 1.0 : 0.0;
    }
    return all > 0.0 ? inside / all : 0.0;
}

}   // namespace

double CenterlineDice::dice() const
{
    const double sum = precision + sensitivity;
    return sum > 0.0 ? 2.0 * precision * sensitivity / sum : 0.0;
}

CenterlineDice centerlineDice(const core::Centerline2d& traced, const core::Mask2d& truth)
{
    core::Mask2d lines(truth.width, truth.height);
    core::Mask2d vessels(truth.width, truth.height);
    for (const core::Curve2d& curve : traced.curves) {
        for (std::size_t i = 0; i < curve.pointsPx.size(); ++i) {
            paint(lines, curve.pointsPx[i], 0.0);
            paint(vessels, curve.pointsPx[i], std::max(minPaintedRadiusPx, curve.radiusPx[i]));
        }
    }
    return {shareInside(lines, truth), shareInside(core::skeletonize(truth), vessels)};
}

core::Mask2d whitePixels(const core::ImageF& picture)
{
    core::Mask2d mask(picture.width, picture.height);
    for (std::size_t i = 0; i < mask.pixels.size(); ++i) {
        mask.pixels[i] = picture.pixels[i] > 127.0F ? 255 : 0;
    }
    return mask;
}

}   // namespace angiopose::test
