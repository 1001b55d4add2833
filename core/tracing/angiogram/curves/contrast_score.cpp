#include "core/tracing/angiogram/curves/contrast_score.h"

#include "core/support/quantile.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double upperQuartile = 0.75;
constexpr double maxRidgeStrength = 15.0;   // cap, in units of `clutter`; stronger ridges are metal, not contrast agent

/// Returns the maximum vesselness in the 3×3 neighborhood, because ridges are narrow and points lie between pixels.
double maxVesselnessAround(const ImageF& vesselness, const Eigen::Vector2d& point)
{
    const int x = static_cast<int>(std::lround(point.x()));
    const int y = static_cast<int>(std::lround(point.y()));
    float strongest = 0.0F;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            strongest = std::max(strongest, vesselness.contains(x + dx, y + dy) ? vesselness.at(x + dx, y + dy) : 0.0F);
        }
    }
    return static_cast<double>(strongest);
}

}   // namespace

double contrastScore(const Centerline2d& centerline, const std::vector<int>& suspectIds, const ImageF& vesselness,
                     double clutter)
{
    std::vector<double> strengths;
    double lengthPx = 0.0;
    double longestPx = 0.0;
    for (const Curve2d& curve : centerline.curves) {
        if (std::ranges::find(suspectIds, curve.id) != suspectIds.end()) {
            continue;
        }
        lengthPx += curve.lengthPx();
        longestPx = std::max(longestPx, curve.lengthPx());
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            strengths.push_back(maxVesselnessAround(vesselness, point));
        }
    }
    const double sidePx = std::max(vesselness.width, vesselness.height);
    if (strengths.empty() || !(clutter > 0.0)) {
        return 0.0;
    }
    const double strength = quantile(std::move(strengths), upperQuartile) / clutter;
    return lengthPx * longestPx / (sidePx * sidePx) * std::min(strength, maxRidgeStrength);
}

}   // namespace angiopose::core
