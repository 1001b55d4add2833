#include "core/simulation/splat_disc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

/// Range of the pixels that a disc can cover.
struct Window {
    int left, right, top, bottom;
};

double coverage(const Eigen::Vector2d& centerPx, double radiusPx, int x, int y)
{
    return std::clamp(radiusPx + 0.5 - std::hypot(x - centerPx.x(), y - centerPx.y()), 0.0, 1.0);
}

}   // namespace

void splatDisc(ImageF& image, const Eigen::Vector2d& centerPx, double radiusPx, double value)
{
    const double drawnRadiusPx = std::max(radiusPx, 0.5);   // a smaller disc could fall between pixel centers
    const double reach = drawnRadiusPx + 0.5;
    if (centerPx.x() < -reach || centerPx.y() < -reach || centerPx.x() > image.width + reach ||
        centerPx.y() > image.height + reach) {
        return;
    }
    const Window window{
        static_cast<int>(std::ceil(centerPx.x() - reach)), static_cast<int>(std::floor(centerPx.x() + reach)),
        static_cast<int>(std::ceil(centerPx.y() - reach)), static_cast<int>(std::floor(centerPx.y() + reach))};
    double covered = 0.0;
    for (int y = window.top; y <= window.bottom; ++y) {
        for (int x = window.left; x <= window.right; ++x) {
            covered += coverage(centerPx, drawnRadiusPx, x, y);
        }
    }
    const double height = value * std::numbers::pi * radiusPx * radiusPx / covered;
    for (int y = std::max(0, window.top); y <= std::min(image.height - 1, window.bottom); ++y) {
        for (int x = std::max(0, window.left); x <= std::min(image.width - 1, window.right); ++x) {
            image.at(x, y) += static_cast<float>(height * coverage(centerPx, drawnRadiusPx, x, y));
        }
    }
}

}   // namespace angiopose::core
