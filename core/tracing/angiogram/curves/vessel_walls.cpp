#include "core/tracing/angiogram/curves/vessel_walls.h"

#include "core/imaging/image_filters.h"
#include "core/support/quantile.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double profileStepPx = 0.5;
constexpr int profilesAveraged = 3;   // on either side
constexpr double maxShiftPx = 2.0;
constexpr double leapPx = 1.0;
constexpr double widestLeap = 1.4;   // times the usual width around

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
    const auto valueAt = [&profile](int k) { return profile[static_cast<std::size_t>(k)]; };
    for (int k = peak; k + direction >= 0 && k + direction < static_cast<int>(profile.size()); k += direction) {
        const double here = valueAt(k);
        const double next = valueAt(k + direction);
        if (here >= level && next < level) {
            return std::abs(k - peak) + (here - level) / (here - next);
        }
    }
    return std::nullopt;
}

std::optional<VesselWalls> wallsOf(const Profile& profile)
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
    return VesselWalls{(peak - centre + 0.5 * (*after - *before)) * profileStepPx,
                       0.5 * (*before + *after) * profileStepPx};
}

std::vector<std::optional<VesselWalls>> wallsAlong(const std::vector<Profile>& profiles)
{
    std::vector<std::optional<VesselWalls>> walls;
    for (std::size_t i = 0; i < profiles.size(); ++i) {
        walls.push_back(wallsOf(meanProfile(profiles, i)));
    }
    return walls;
}

/// Without walls that leap from those around them: there another vessel crosses or joins.
std::vector<std::optional<VesselWalls>> plausible(const std::vector<std::optional<VesselWalls>>& walls)
{
    constexpr std::size_t reach = 15;
    std::vector<std::optional<VesselWalls>> kept(walls.size());
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

}   // namespace

std::vector<std::optional<VesselWalls>> findWalls(const std::vector<Eigen::Vector2d>& points,
                                                  const std::vector<Eigen::Vector2d>& normals, const ImageF& opacity,
                                                  double reachPx)
{
    const int half = static_cast<int>(std::ceil(reachPx / profileStepPx));
    return plausible(wallsAlong(profilesAcross(points, normals, opacity, half)));
}

}   // namespace angiopose::core