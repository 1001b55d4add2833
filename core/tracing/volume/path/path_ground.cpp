#include "core/tracing/volume/path/path_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

// Shell radii just beyond the wall, for vessels from coronary branches to the aorta.
constexpr std::array shellRadiiMm{1.2, 1.8, 2.6, 3.6, 5.0, 7.0, 10.0, 14.0};
constexpr double shellBeyondWall = 1.2;
constexpr double clearDrop = 0.4;   // minimum drop beside the voxel, relative to its contrast to tissue
// In a straight tube, about 9 of 13 directions lead out of it; in a sheet-like wall 4, in a homogeneous region 0.
constexpr double minShareOfTube = 0.35;
constexpr double shareOfTube = 0.65;
constexpr int directions = 13;
constexpr double tissueReachMm = 6.0;
constexpr double tissueRank = 0.3;   // quantile of the surrounding values; vessels occupy the smaller part

/// Returns steps in half of the 26 directions, no two of them opposite.
std::vector<Eigen::Vector3i> halfShell(double radiusMm, const Eigen::Vector3d& spacingMm)
{
    std::vector<Eigen::Vector3i> steps;
    for (int n = 14; n < 27; ++n) {   // the second half of the 26 neighbors
        const Eigen::Vector3d way(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
        const Eigen::Vector3d step = (radiusMm * way.normalized()).cwiseQuotient(spacingMm);
        steps.emplace_back(step.array().round().cast<int>());
    }
    return steps;
}

/// Returns how tube-like the surroundings of a voxel are (0…1), from the number of opposite pairs that are both darker.
double shareOfPairs(int darker)
{
    const double share = static_cast<double>(darker) / directions;
    return std::clamp((share - minShareOfTube) / (shareOfTube - minShareOfTube), 0.0, 1.0);
}

}   // namespace

PathGround::PathGround(const Volume& volume, double widestRadiusMm) : volume_(volume)
{
    for (const double radiusMm : shellRadiiMm) {
        if (radiusMm > shellBeyondWall * widestRadiusMm) {
            break;
        }
        Shell shell{radiusMm, halfShell(radiusMm, volume.geometry.spacingMm), {}};
        const auto isNone = [](const Eigen::Vector3i& step) { return step == Eigen::Vector3i::Zero(); };
        if (std::ranges::none_of(shell.steps, isNone)) {
            for (const Eigen::Vector3i& step : shell.steps) {
                const std::ptrdiff_t rows = static_cast<std::ptrdiff_t>(step.z()) * volume.geometry.size.y() + step.y();
                shell.offsets.push_back(rows * volume.geometry.size.x() + step.x());
                shell.reach = shell.reach.cwiseMax(step.cwiseAbs());
            }
            shells_.push_back(std::move(shell));
        }
    }
}

double PathGround::valueAt(const Eigen::Vector3i& voxel) const
{
    const Eigen::Vector3i inside = voxel.cwiseMax(0).cwiseMin((volume_.geometry.size.array() - 1).matrix());
    return volume_.value(volume_.geometry.index(inside.x(), inside.y(), inside.z()));
}

/// Counts the pairs with both values ≤ `limit`; returns 0 as soon as `atLeast` pairs can no longer be reached.
int PathGround::darkerPairs(const Shell& shell, const Eigen::Vector3i& voxel, double limit, int atLeast) const
{
    const VolumeGeometry& grid = volume_.geometry;
    const bool isInside =
        ((voxel - shell.reach).array() >= 0).all() && ((voxel + shell.reach).array() < grid.size.array()).all();
    const auto at = static_cast<std::ptrdiff_t>(isInside ? grid.index(voxel.x(), voxel.y(), voxel.z()) : 0);
    int darker = 0;
    for (std::size_t n = 0; n < shell.steps.size(); ++n) {
        const bool isDarker =
            isInside ? volume_.value(static_cast<std::size_t>(at + shell.offsets[n])) <= limit &&
                           volume_.value(static_cast<std::size_t>(at - shell.offsets[n])) <= limit
                     : valueAt(voxel + shell.steps[n]) <= limit && valueAt(voxel - shell.steps[n]) <= limit;
        darker += isDarker ? 1 : 0;
        if (darker + directions - static_cast<int>(n) - 1 < atLeast) {
            return 0;
        }
    }
    return darker;
}

TubeLook PathGround::tube(const Eigen::Vector3i& voxel, double tissue) const
{
    const double here = valueAt(voxel);
    const double drop = clearDrop * (here - tissue);
    if (drop <= 0.0) {
        return {};
    }
    TubeLook look;
    int most = 0;
    for (const Shell& shell : shells_) {
        if (const int count = darkerPairs(shell, voxel, here - drop, most + 1); count > most) {
            most = count;
            look.shellMm = shell.radiusMm;
        }
    }
    look.share = shareOfPairs(most);
    return look;
}

double PathGround::tubeShare(const Eigen::Vector3i& voxel, double tissue) const
{
    const double here = valueAt(voxel);
    const double drop = clearDrop * (here - tissue);
    if (drop <= 0.0) {
        return 0.0;
    }
    const int minThatCounts = static_cast<int>(std::floor(minShareOfTube * directions)) + 1;
    int most = 0;
    for (const Shell& shell : shells_) {
        most = std::max(most, darkerPairs(shell, voxel, here - drop, std::max(most + 1, minThatCounts)));
        if (shareOfPairs(most) >= 1.0) {
            break;
        }
    }
    return shareOfPairs(most);
}

std::vector<double> PathGround::valuesAround(const Eigen::Vector3i& voxel, double distanceMm) const
{
    std::vector<double> values;
    for (const Eigen::Vector3i& step : halfShell(distanceMm, volume_.geometry.spacingMm)) {
        values.push_back(valueAt(voxel + step));
        values.push_back(valueAt(voxel - step));
    }
    return values;
}

VesselLook PathGround::lookAt(const Eigen::Vector3i& voxel) const
{
    const Eigen::Vector3i reach =
        (tissueReachMm * volume_.geometry.spacingMm.cwiseInverse()).array().ceil().cast<int>();
    std::vector<double> around;
    for (int k = -reach.z(); k <= reach.z(); ++k) {
        for (int j = -reach.y(); j <= reach.y(); ++j) {
            for (int i = -reach.x(); i <= reach.x(); ++i) {
                around.push_back(valueAt(voxel + Eigen::Vector3i(i, j, k)));
            }
        }
    }
    const auto rank = around.begin() + static_cast<std::ptrdiff_t>(tissueRank * static_cast<double>(around.size() - 1));
    std::nth_element(around.begin(), rank, around.end());
    return {valueAt(voxel), *rank};
}

Eigen::Vector3i PathGround::likeliestNear(const Eigen::Vector3i& voxel, double reachMm) const
{
    const Eigen::Vector3d& spacing = volume_.geometry.spacingMm;
    const Eigen::Vector3i reach = (reachMm * spacing.cwiseInverse()).array().floor().cast<int>();
    const double tissue = lookAt(voxel).tissue;
    double best = -std::numeric_limits<double>::infinity();
    Eigen::Vector3i likeliest = voxel;
    for (int k = -reach.z(); k <= reach.z(); ++k) {
        for (int j = -reach.y(); j <= reach.y(); ++j) {
            for (int i = -reach.x(); i <= reach.x(); ++i) {
                const Eigen::Vector3i at = voxel + Eigen::Vector3i(i, j, k);
                const double awayMm = Eigen::Vector3d(i, j, k).cwiseProduct(spacing).norm();
                if (awayMm > reachMm || !volume_.geometry.contains(at)) {
                    continue;
                }
                const double likely =
                    (valueAt(at) - tissue) * (0.3 + tube(at, tissue).share) * (1.0 - 0.5 * awayMm / reachMm);
                if (likely > best) {
                    best = likely;
                    likeliest = at;
                }
            }
        }
    }
    return likeliest;
}

}   // namespace angiopose::core
