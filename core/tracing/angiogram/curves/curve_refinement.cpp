#include "core/tracing/angiogram/curves/curve_refinement.h"

#include "core/imaging/image_filters.h"
#include "core/support/quantile.h"
#include "core/tracing/angiogram/curves/vessel_walls.h"
#include "core/vessel/polyline.h"
#include "core/vessel/smoothing_spline.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double profileMarginPx = 3.0;
constexpr double skeletonLambda = 4.0;
constexpr double finalLambda = 10.0;
constexpr double weightWithoutWalls = 0.05;
constexpr double minRadiusAtEnd = 0.6;   // minimum, relative to the typical radius
constexpr int curveTangentReach = 4;
// The absorption of a round tube follows its chord 2√(r² − x²), which falls to half at x = r √3/2.
constexpr double halfDepthPerRadius = 0.8660254;

std::vector<Eigen::Vector2d> evenlySpaced(const std::vector<Eigen::Vector2d>& points)
{
    return interpolate(points, evenStations(points, 1.0));
}

std::vector<Eigen::Vector2d> normalsOf(const std::vector<Eigen::Vector2d>& points)
{
    std::vector<Eigen::Vector2d> normals = tangentsOf(points, curveTangentReach);
    for (Eigen::Vector2d& normal : normals) {
        normal = Eigen::Vector2d(-normal.y(), normal.x());
    }
    return normals;
}

/// Fills in missing (negative) radii from the nearest known radii, or with 1 px if none is known, then applies a
/// running median against outliers.
std::vector<double> fillMissingRadii(const std::vector<double>& radii)
{
    std::vector<double> known = radii;
    double last = 1.0;
    const auto first = std::find_if(radii.begin(), radii.end(), [](double r) { return r >= 0.0; });
    if (first != radii.end()) {
        last = *first;
    }
    for (double& radius : known) {
        radius = radius >= 0.0 ? radius : last;
        last = radius;
    }
    constexpr std::size_t reach = 5;
    std::vector<double> result;
    for (std::size_t i = 0; i < known.size(); ++i) {
        const auto from = known.begin() + static_cast<std::ptrdiff_t>(i >= reach ? i - reach : 0);
        const auto to = known.begin() + static_cast<std::ptrdiff_t>(std::min(known.size(), i + reach + 1));
        std::vector<double> window(from, to);
        std::nth_element(window.begin(), window.begin() + static_cast<std::ptrdiff_t>(window.size() / 2), window.end());
        result.push_back(window[window.size() / 2]);
    }
    return result;
}

/// Returns the mean opacity over a few points around the i-th point.
double meanOpacityAround(const Curve2d& curve, const ImageF& opacity, std::size_t i)
{
    constexpr std::size_t reach = 2;
    const std::size_t first = i >= reach ? i - reach : 0;
    const std::size_t last = std::min(curve.pointsPx.size() - 1, i + reach);
    double sum = 0.0;
    for (std::size_t k = first; k <= last; ++k) {
        sum += sampleBilinear(opacity, curve.pointsPx[k].x(), curve.pointsPx[k].y());
    }
    return sum / static_cast<double>(last - first + 1);
}

/// Counts the points at one end that lie beyond the vessel, where the ridge filter overshoots: points with less than
/// half the median opacity of the end section.
std::size_t countPointsBeyondVessel(const Curve2d& curve, const ImageF& opacity, std::size_t maxCount)
{
    std::vector<double> depths;
    for (std::size_t i = 0; i < std::min(curve.pointsPx.size(), 3 * maxCount); ++i) {
        depths.push_back(meanOpacityAround(curve, opacity, i));
    }
    const double limit = 0.5 * quantile(depths, 0.5);
    std::size_t beyond = 0;
    while (beyond < std::min(maxCount, depths.size() / 3) && depths[beyond] < limit) {
        ++beyond;
    }
    return beyond;
}

double typicalRadius(const Curve2d& curve)
{
    constexpr std::size_t sample = 40;
    const auto last = curve.radiusPx.begin() + static_cast<std::ptrdiff_t>(std::min(sample, curve.radiusPx.size()));
    return quantile({curve.radiusPx.begin(), last}, 0.5);
}

/// Returns the number of points to trim at one end: those beyond the vessel, and those where the skeleton hooks
/// sideways and no walls are found. Ridges of wide vessels overshoot farther than those of thin ones.
std::size_t countPointsToTrim(const Curve2d& curve, const std::vector<bool>& hasWalls, const ImageF& opacity)
{
    const double radius = typicalRadius(curve);
    const auto maxBeyond = static_cast<std::size_t>(std::ceil(3.0 * radius)) + 4;
    const auto maxHooked = std::min(static_cast<std::size_t>(std::ceil(radius)) + 1, hasWalls.size() / 3);
    std::size_t hooked = 0;
    while (hooked < maxHooked && (!hasWalls[hooked] || curve.radiusPx[hooked] < minRadiusAtEnd * radius)) {
        ++hooked;
    }
    return std::max(countPointsBeyondVessel(curve, opacity, maxBeyond), hooked);
}

void trimEnds(Curve2d& curve, std::vector<bool> hasWalls, const ImageF& opacity)
{
    for (int end = 0; end < 2; ++end) {
        const auto cut = static_cast<std::ptrdiff_t>(countPointsToTrim(curve, hasWalls, opacity));
        curve.pointsPx.erase(curve.pointsPx.begin(), curve.pointsPx.begin() + cut);
        curve.radiusPx.erase(curve.radiusPx.begin(), curve.radiusPx.begin() + cut);
        hasWalls.erase(hasWalls.begin(), hasWalls.begin() + cut);
        std::reverse(curve.pointsPx.begin(), curve.pointsPx.end());
        std::reverse(curve.radiusPx.begin(), curve.radiusPx.end());
        std::reverse(hasWalls.begin(), hasWalls.end());
    }
}

}   // namespace

Curve2d smoothCurve(const std::vector<Eigen::Vector2d>& pathPx, int id)
{
    const std::vector<Eigen::Vector2d> even = evenlySpaced(pathPx);
    return {id, smoothSpline(even, std::vector<double>(even.size(), 1.0), skeletonLambda), {}};
}

Curve2d centerCurve(const std::vector<Eigen::Vector2d>& pathPx, int id, const ImageF& opacity, double maxRadiusPx)
{
    Curve2d curve = smoothCurve(pathPx, id);
    std::vector<bool> hasWalls(curve.pointsPx.size());
    for (int round = 0; round < 2; ++round) {
        const std::vector<Eigen::Vector2d> normals = normalsOf(curve.pointsPx);
        const auto walls = findWalls(curve.pointsPx, normals, opacity, maxRadiusPx + profileMarginPx);
        std::vector<double> weights(curve.pointsPx.size(), weightWithoutWalls);
        std::vector<double> radii(curve.pointsPx.size(), -1.0);
        for (std::size_t i = 0; i < curve.pointsPx.size(); ++i) {
            hasWalls[i] = walls[i].has_value();
            if (walls[i]) {
                curve.pointsPx[i] += walls[i]->centerOffsetPx * normals[i];
                radii[i] = walls[i]->halfWidthPx / halfDepthPerRadius;
                weights[i] = 1.0;
            }
        }
        curve.pointsPx = smoothSpline(curve.pointsPx, weights, finalLambda);
        curve.radiusPx = fillMissingRadii(radii);
    }
    trimEnds(curve, std::move(hasWalls), opacity);
    return curve;
}

}   // namespace angiopose::core
