#include "tests/benchmark/foreign/tracer.h"

#include "tests/benchmark/foreign/detector.h"

#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace angiopose::benchmarks {
namespace {

constexpr double stepPx = 1.37;   // differs from the sampling of the tree
constexpr double jitterPx = 0.5;
constexpr double jitterReachPx = 15.0;

/// Resamples a polyline every `stepPx`, with a random phase.
Pixels walked(const Pixels& curve, ForeignRandom& random)
{
    Pixels points;
    double toNext = random.uniform(0.0, stepPx);
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const Eigen::Vector2d way = curve[i] - curve[i - 1];
        const double length = way.norm();
        double at = toNext;
        for (; at < length; at += stepPx) {
            points.emplace_back(curve[i - 1] + at / length * way);
        }
        toNext = at - length;
    }
    return points;
}

void shuffle(Pixels& points, ForeignRandom& random)
{
    for (std::size_t left = points.size(); left > 1; --left) {
        std::swap(points[left - 1], points[random.index(left)]);
    }
}

/// Pixels row by row, each once, as read from a mask.
Pixels asPixels(const Pixels& points)
{
    std::set<std::pair<double, double>> rows;
    for (const Eigen::Vector2d& point : points) {
        rows.insert({point.y(), point.x()});
    }
    Pixels pixels;
    for (const auto& [v, u] : rows) {
        pixels.emplace_back(u, v);
    }
    return pixels;
}

}   // namespace

Pixels traced(const Pixels& curve, ForeignRandom& random)
{
    const double kept = std::exp(-stepPx / jitterReachPx);
    Eigen::Vector2d jitter(random.normal(), random.normal());
    Pixels points;
    for (const Eigen::Vector2d& point : walked(curve, random)) {
        jitter = kept * jitter + std::sqrt(1.0 - kept * kept) * Eigen::Vector2d(random.normal(), random.normal());
        const Eigen::Vector2d off = point + jitterPx * jitter;
        if (isOnDetector(off)) {
            points.emplace_back(std::round(off.x()), std::round(off.y()));
        }
    }
    return points;
}

Pixels foreignCurve(ForeignRandom& random)
{
    Eigen::Vector2d at(random.uniform(0.15, 0.85) * imagePx, random.uniform(0.15, 0.85) * imagePx);
    double heading = random.uniform(0.0, 2.0 * std::numbers::pi);
    double deformation = 0.0;
    Pixels curve;
    for (int steps = 40 + static_cast<int>(random.index(80)); steps > 0; --steps) {
        curve.push_back(at);
        deformation = 0.9 * deformation + 0.02 * random.normal();
        heading += deformation;
        at += 3.0 * Eigen::Vector2d(std::cos(heading), std::sin(heading));
    }
    return curve;
}

std::vector<Pixels> seen(const RootedTree& shown, const std::vector<std::size_t>& filled,
                         const core::RigidTransform& cameraFromPatient, ForeignRandom& random)
{
    std::vector<Pixels> curves;
    for (const std::size_t branch : filled) {
        Pixels projected;
        for (const Eigen::Vector3d& point : shown.tree.branches[branch].pointsInPatient) {
            projected.push_back(pixelOf(cameraFromPatient * point));
        }
        curves.push_back(traced(projected, random));
    }
    return curves;
}

std::vector<Pixels> noVessels(ForeignScene scene, ForeignRandom& random)
{
    const bool isCurves = scene == ForeignScene::Scribbles;
    std::vector<Pixels> found(isCurves ? 2000 : 20'000);
    for (Pixels& curve : found) {
        Eigen::Vector2d at(random.uniform(0.0, imagePx - 1.0), random.uniform(0.0, imagePx - 1.0));
        double heading = random.uniform(0.0, 2.0 * std::numbers::pi);
        for (int left = isCurves ? 66 : 1; left > 0 && at.minCoeff() >= 0.0 && at.maxCoeff() < imagePx; --left) {
            curve.push_back(at);
            heading += 0.15 * random.normal();
            at += stepPx * Eigen::Vector2d(std::cos(heading), std::sin(heading));
        }
    }
    return found;
}

core::Centerline2d handedOver(std::vector<Pixels> curves, ForeignScene scene, ForeignRandom& random)
{
    if (scene == ForeignScene::ShuffledPoints || scene == ForeignScene::SkeletonPixels) {
        Pixels all;
        for (const Pixels& curve : curves) {
            all.insert(all.end(), curve.begin(), curve.end());
        }
        curves = {scene == ForeignScene::SkeletonPixels ? asPixels(all) : all};
    }
    core::Centerline2d target;
    for (Pixels& curve : curves) {
        if (scene == ForeignScene::ShuffledPoints || scene == ForeignScene::ShuffledRows) {
            shuffle(curve, random);
        }
        if (!curve.empty()) {
            target.curves.push_back({static_cast<int>(target.curves.size()), std::move(curve), {}});
        }
    }
    return target;
}

}   // namespace angiopose::benchmarks
