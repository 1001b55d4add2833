#include "core/tracing/angiogram/curves/vessel_walls.h"

#include "core/imaging/image_filters.h"
#include "core/support/quantile.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace angiopose::core {
namespace {

constexpr double profileStepPx = 0.5;
constexpr int profilesAveraged = 3;   // number of profiles on either side of the point
constexpr double maxShiftPx = 2.0;
constexpr double maxJumpPx = 1.0;
constexpr double maxWidthRatio = 1.4;   // maximum width relative to the typical width nearby

using Profile = std::span<const double>;

/// Opacity profiles perpendicular to a curve: one row per point, from −half to +half profile steps.
class Profiles {
public:
    Profiles(const std::vector<Eigen::Vector2d>& points, const std::vector<Eigen::Vector2d>& normals,
             const ImageF& opacity, int half)
        : count_(points.size()), length_(static_cast<std::size_t>(2 * half + 1)), values_(count_ * length_)
    {
        auto value = values_.begin();
        for (std::size_t i = 0; i < count_; ++i) {
            for (int k = -half; k <= half; ++k) {
                const Eigen::Vector2d at = points[i] + k * profileStepPx * normals[i];
                *value++ = sampleBilinear(opacity, at.x(), at.y());
            }
        }
        scaledValues_ = values_;
        for (double& share : scaledValues_) {
            share /= fullCount;
        }
    }

    std::size_t count() const { return count_; }

    /// Computes the mean of the profiles around profile `center`.
    void meanAround(std::size_t center, std::vector<double>& mean) const
    {
        const std::size_t first = center >= profilesAveraged ? center - profilesAveraged : 0;
        const std::size_t last = std::min(count_ - 1, center + profilesAveraged);
        mean.assign(length_, 0.0);
        const auto averaged = static_cast<double>(last - first + 1);
        for (std::size_t row = first * length_; row < (last + 1) * length_; row += length_) {
            for (std::size_t k = 0; k < length_; ++k) {
                mean[k] += averaged == fullCount ? scaledValues_[row + k] : values_[row + k] / averaged;
            }
        }
    }

private:
    static constexpr double fullCount = 2 * profilesAveraged + 1;

    std::size_t count_;
    std::size_t length_;
    std::vector<double> values_;
    std::vector<double> scaledValues_;   ///< values divided by the full number of averaged profiles
};

/// Returns the distance from `peak`, in (fractional) steps along `direction` (±1), at which the profile falls to
/// `level`; nullopt if it never does.
std::optional<double> distanceToLevel(Profile profile, int peak, int direction, double level)
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

std::optional<VesselWalls> wallsOf(Profile profile)
{
    const int center = static_cast<int>(profile.size()) / 2;
    const int search = static_cast<int>(maxShiftPx / profileStepPx);
    const auto peak = static_cast<int>(
        std::max_element(profile.begin() + std::max(0, center - search), profile.begin() + center + search + 1) -
        profile.begin());
    const double top = profile[static_cast<std::size_t>(peak)];
    const double left = *std::min_element(profile.begin(), profile.begin() + peak + 1);
    const double right = *std::min_element(profile.begin() + peak, profile.end());
    const double level = 0.5 * (top + std::max(left, right));
    const auto before = distanceToLevel(profile, peak, -1, level);
    const auto after = distanceToLevel(profile, peak, 1, level);
    if (!before || !after) {
        return std::nullopt;
    }
    return VesselWalls{(peak - center + 0.5 * (*after - *before)) * profileStepPx,
                       0.5 * (*before + *after) * profileStepPx};
}

std::vector<std::optional<VesselWalls>> wallsAlong(const Profiles& profiles)
{
    std::vector<std::optional<VesselWalls>> walls;
    walls.reserve(profiles.count());
    std::vector<double> mean;
    for (std::size_t i = 0; i < profiles.count(); ++i) {
        profiles.meanAround(i, mean);
        walls.push_back(wallsOf(mean));
    }
    return walls;
}

/// Returns the median of a property of the known walls around a point.
double localMedian(const std::vector<std::optional<VesselWalls>>& walls, std::size_t i, double VesselWalls::*part)
{
    constexpr std::size_t reach = 15;
    std::vector<double> known;
    known.reserve(2 * reach + 1);
    for (std::size_t k = i >= reach ? i - reach : 0; k < std::min(walls.size(), i + reach + 1); ++k) {
        if (walls[k]) {
            known.push_back((*walls[k]).*part);
        }
    }
    return quantile(std::move(known), 0.5);
}

/// Drops walls that jump relative to those around them, because another vessel crosses or joins there.
std::vector<std::optional<VesselWalls>> removeJumps(const std::vector<std::optional<VesselWalls>>& walls)
{
    std::vector<std::optional<VesselWalls>> filtered(walls.size());
    for (std::size_t i = 0; i < walls.size(); ++i) {
        if (walls[i] && std::abs(walls[i]->centerOffsetPx) <= maxShiftPx &&
            std::abs(walls[i]->centerOffsetPx - localMedian(walls, i, &VesselWalls::centerOffsetPx)) <= maxJumpPx &&
            walls[i]->halfWidthPx <= maxWidthRatio * localMedian(walls, i, &VesselWalls::halfWidthPx)) {
            filtered[i] = walls[i];
        }
    }
    return filtered;
}

}   // namespace

std::vector<std::optional<VesselWalls>> findWalls(const std::vector<Eigen::Vector2d>& points,
                                                  const std::vector<Eigen::Vector2d>& normals, const ImageF& opacity,
                                                  double reachPx)
{
    const int half = static_cast<int>(std::ceil(reachPx / profileStepPx));
    return removeJumps(wallsAlong({points, normals, opacity, half}));
}

}   // namespace angiopose::core
