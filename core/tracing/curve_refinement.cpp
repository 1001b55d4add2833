#include "core/tracing/curve_refinement.h"

#include "core/imaging/image_filters.h"
#include "core/support/quantile.h"
#include "core/vessel/polyline.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace core {
namespace {

constexpr double profileStepPx = 0.5;
constexpr double profileMarginPx = 3.0;
constexpr int profilesAveraged = 3;   // on either side
constexpr double skeletonLambda = 10.0;
constexpr double finalLambda = 20.0;
constexpr double maxShiftPx = 2.0;
constexpr double leapPx = 1.0;
constexpr double widestLeap = 1.4;
constexpr double unsureWeight = 0.05;
constexpr int tangentReach = 4;
// A round tube absorbs along its chord 2√(r² − x²), which halves at x = r √3/2.
constexpr double halfDepthPerRadius = 0.8660254;

std::vector<Eigen::Vector2d> evenlySpaced(const std::vector<Eigen::Vector2d>& points)
{
    return interpolate(points, evenStations(points, 1.0));
}

std::vector<Eigen::Vector2d> normalsOf(const std::vector<Eigen::Vector2d>& points)
{
    std::vector<Eigen::Vector2d> normals = tangentsOf(points, tangentReach);
    for (Eigen::Vector2d& normal : normals) {
        normal = Eigen::Vector2d(-normal.y(), normal.x());
    }
    return normals;
}

using Profile = std::vector<double>;

/// Opacity across each point, from −half to +half in profile steps.
std::vector<Profile> profilesAcross(const std::vector<Eigen::Vector2d>& points,
                                    const std::vector<Eigen::Vector2d>& normals, const ImageF& opacity, int half)
{
    std::vector<Profile> profiles;
    for (std::size_t i = 0; i < points.size(); ++i) {
        Profile profile;
        for (int k = -half; k <= half; ++k) {
            const Eigen::Vector2d at = points[i] + k * profileStepPx * normals[i];
            profile.push_back(sampled(opacity, at.x(), at.y()));
        }
        profiles.push_back(std::move(profile));
    }
    return profiles;
}

Profile meanProfile(const std::vector<Profile>& profiles, std::size_t centre)
{
    const std::size_t first = centre >= profilesAveraged ? centre - profilesAveraged : 0;
    const std::size_t last = std::min(profiles.size() - 1, centre + profilesAveraged);
    Profile mean(profiles[centre].size(), 0.0);
    for (std::size_t i = first; i <= last; ++i) {
        for (std::size_t k = 0; k < mean.size(); ++k) {
            mean[k] += profiles[i][k] / static_cast<double>(last - first + 1);
        }
    }
    return mean;
}

/// Steps from `peak` in direction ±1 to where the profile falls to `level`, with fraction; nothing if it does not.
std::optional<double> fallBelow(const Profile& profile, int peak, int direction, double level)
{
    for (int k = peak; k + direction >= 0 && k + direction < static_cast<int>(profile.size()); k += direction) {
        const double here = profile[static_cast<std::size_t>(k)];
        const double next = profile[static_cast<std::size_t>(k + direction)];
        if (here >= level && next < level) {
            return std::abs(k - peak) + (here - level) / (here - next);
        }
    }
    return std::nullopt;
}

struct Walls {
    double middlePx;   ///< along the normal, from the point
    double halfWidthPx;
};

std::optional<Walls> wallsOf(const Profile& profile)
{
    const int centre = static_cast<int>(profile.size()) / 2;
    const int search = static_cast<int>(maxShiftPx / profileStepPx);
    const auto peak = static_cast<int>(
        std::max_element(profile.begin() + std::max(0, centre - search), profile.begin() + centre + search + 1) -
        profile.begin());
    const double top = profile[static_cast<std::size_t>(peak)];
    const double left = *std::min_element(profile.begin(), profile.begin() + peak + 1);
    const double right = *std::min_element(profile.begin() + peak, profile.end());
    const double level = 0.5 * (top + std::max(left, right));
    const auto before = fallBelow(profile, peak, -1, level);
    const auto after = fallBelow(profile, peak, 1, level);
    if (!before || !after) {
        return std::nullopt;
    }
    return Walls{(peak - centre + 0.5 * (*after - *before)) * profileStepPx, 0.5 * (*before + *after) * profileStepPx};
}

std::vector<std::optional<Walls>> wallsAlong(const std::vector<Profile>& profiles)
{
    std::vector<std::optional<Walls>> walls;
    for (std::size_t i = 0; i < profiles.size(); ++i) {
        walls.push_back(wallsOf(meanProfile(profiles, i)));
    }
    return walls;
}

/// Without walls that leap from those around them: there another vessel crosses or joins.
std::vector<std::optional<Walls>> plausible(const std::vector<std::optional<Walls>>& walls)
{
    constexpr std::size_t reach = 15;
    std::vector<std::optional<Walls>> kept(walls.size());
    for (std::size_t i = 0; i < walls.size(); ++i) {
        std::vector<double> middles;
        std::vector<double> widths;
        for (std::size_t k = i >= reach ? i - reach : 0; k < std::min(walls.size(), i + reach + 1); ++k) {
            if (walls[k]) {
                middles.push_back(walls[k]->middlePx);
                widths.push_back(walls[k]->halfWidthPx);
            }
        }
        if (walls[i] && std::abs(walls[i]->middlePx - quantile(middles, 0.5)) <= leapPx &&
            std::abs(walls[i]->middlePx) <= maxShiftPx && walls[i]->halfWidthPx <= widestLeap * quantile(widths, 0.5)) {
            kept[i] = walls[i];
        }
    }
    return kept;
}

/// Missing radii (negative) by the nearest known ones; 1 px if none is known. Then a running median against leaps.
std::vector<double> filledRadii(const std::vector<double>& radii)
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

}   // namespace

std::vector<Eigen::Vector2d> smoothed(const std::vector<Eigen::Vector2d>& points, const std::vector<double>& weights,
                                      double lambda)
{
    const std::size_t n = points.size();
    if (n < 3) {
        return points;
    }
    // Symmetric band matrix W + λ DᵀD with two side diagonals, factored in place as L D Lᵀ.
    std::vector<double> diagonal = weights;
    std::vector<double> upper1(n, 0.0);
    std::vector<double> upper2(n, 0.0);
    for (std::size_t k = 0; k + 2 < n; ++k) {
        diagonal[k] += lambda;
        diagonal[k + 1] += 4.0 * lambda;
        diagonal[k + 2] += lambda;
        upper1[k] -= 2.0 * lambda;
        upper1[k + 1] -= 2.0 * lambda;
        upper2[k] += lambda;
    }
    std::vector<Eigen::Vector2d> x(n);
    for (std::size_t i = 0; i < n; ++i) {
        x[i] = weights[i] * points[i];
    }
    for (std::size_t i = 0; i < n; ++i) {
        const double factor1 = upper1[i] / diagonal[i];
        const double factor2 = upper2[i] / diagonal[i];
        if (i + 1 < n) {
            diagonal[i + 1] -= factor1 * upper1[i];
            upper1[i + 1] -= factor1 * upper2[i];
            x[i + 1] -= factor1 * x[i];
        }
        if (i + 2 < n) {
            diagonal[i + 2] -= factor2 * upper2[i];
            x[i + 2] -= factor2 * x[i];
        }
        x[i] /= diagonal[i];
        upper1[i] = factor1;
        upper2[i] = factor2;
    }
    for (std::size_t i = n; i-- > 0;) {
        if (i + 1 < n) {
            x[i] -= upper1[i] * x[i + 1];
        }
        if (i + 2 < n) {
            x[i] -= upper2[i] * x[i + 2];
        }
    }
    return x;
}

Curve2d smoothCurve(const std::vector<Eigen::Vector2d>& pathPx, int id)
{
    const std::vector<Eigen::Vector2d> even = evenlySpaced(pathPx);
    return {id, smoothed(even, std::vector<double>(even.size(), 1.0), skeletonLambda), {}};
}

Curve2d centredCurve(const std::vector<Eigen::Vector2d>& pathPx, int id, const ImageF& opacity, double maxRadiusPx)
{
    Curve2d curve = smoothCurve(pathPx, id);
    const int half = static_cast<int>(std::ceil((maxRadiusPx + profileMarginPx) / profileStepPx));
    for (int round = 0; round < 2; ++round) {
        const std::vector<Eigen::Vector2d> normals = normalsOf(curve.pointsPx);
        const std::vector<std::optional<Walls>> walls =
            plausible(wallsAlong(profilesAcross(curve.pointsPx, normals, opacity, half)));
        std::vector<double> weights(curve.pointsPx.size(), unsureWeight);
        std::vector<double> radii(curve.pointsPx.size(), -1.0);
        for (std::size_t i = 0; i < curve.pointsPx.size(); ++i) {
            if (walls[i]) {
                curve.pointsPx[i] += walls[i]->middlePx * normals[i];
                radii[i] = walls[i]->halfWidthPx / halfDepthPerRadius;
                weights[i] = 1.0;
            }
        }
        curve.pointsPx = smoothed(curve.pointsPx, weights, finalLambda);
        curve.radiusPx = filledRadii(radii);
    }
    return curve;
}

}   // namespace core
