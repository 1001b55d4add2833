#include "core/simulation/degrade_target.h"

#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double missingShare = 0.2;
constexpr double clutterLengthPx = 500.0;

/// Adds AR(1) noise to both coordinates.
void jitter(Curve2d& curve, CounterRandom& random)
{
    const double correlation = std::exp(-1.0 / degradedCorrelationPoints);
    const double innovationStd = degradedJitterPx * std::sqrt(1.0 - correlation * correlation);
    Eigen::Vector2d noise = Eigen::Vector2d::Zero();
    bool isFirst = true;
    for (Eigen::Vector2d& point : curve.pointsPx) {
        const double x = random.normal();
        const double y = random.normal();
        const Eigen::Vector2d white(x, y);
        noise = isFirst ? (degradedJitterPx * white).eval() : (correlation * noise + innovationStd * white).eval();
        isFirst = false;
        point += noise;
    }
}

/// Rounds the points to whole pixels and uses each pixel at most once in the whole target.
Curve2d rasterized(const Curve2d& curve, std::set<std::pair<int, int>>& taken)
{
    Curve2d result{curve.id, {}, {}};
    for (const Eigen::Vector2d& point : curve.pointsPx) {
        const int x = static_cast<int>(std::lround(point.x()));
        const int y = static_cast<int>(std::lround(point.y()));
        if (taken.emplace(x, y).second) {
            result.pointsPx.emplace_back(x, y);
        }
    }
    return result;
}

/// Draws a smooth meandering line that resembles a guidewire or the edge of a bone.
Curve2d drawClutter(const ProjectionCamera& camera, CounterRandom& random)
{
    Curve2d curve{-1, {}, {}};
    Eigen::Vector2d point(random.uniform(0.2, 0.8) * camera.width, random.uniform(0.2, 0.8) * camera.height);
    double direction = random.uniform(0.0, 2.0 * std::numbers::pi);
    double turn = 0.0;
    for (double along = 0.0; along < clutterLengthPx; along += 1.0) {
        curve.pointsPx.push_back(point);
        turn = 0.97 * turn + 0.002 * random.normal();
        direction += turn;
        point += Eigen::Vector2d(std::cos(direction), std::sin(direction));
    }
    return curve;
}

}   // namespace

Centerline2d addTracingErrors(const Centerline2d& exact, const ProjectionCamera& camera, CounterRandom random)
{
    Centerline2d result;
    std::set<std::pair<int, int>> taken;
    for (Curve2d curve : resampled(exact, 1.0).curves) {
        const bool isMissing = random.uniform() < missingShare;
        jitter(curve, random);
        Curve2d pixels = rasterized(curve, taken);
        if (!isMissing && !pixels.pointsPx.empty()) {
            result.curves.push_back(std::move(pixels));
        }
    }
    result.curves.push_back(rasterized(drawClutter(camera, random), taken));
    return result;
}

}   // namespace angiopose::core
