#include "core/tracing/volume/path/tube_detector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

// Shell radii just beyond the wall, for vessels from coronary branches to the aorta.
constexpr std::array shellRadiiMm{1.2, 1.8, 2.6, 3.6, 5.0, 7.0, 10.0, 14.0};
constexpr double shellBeyondWall = 1.2;
constexpr double minRelativeDrop = 0.4;   // minimum drop beside the voxel, relative to its contrast to tissue
// In a straight tube, about 9 of 13 directions lead out of it; in a sheet-like wall 4, in a homogeneous region 0.
constexpr double minPairFraction = 0.35;
constexpr double fullPairFraction = 0.65;
constexpr int directions = 13;
constexpr double tissueReachMm = 6.0;
constexpr double tissueQuantile = 0.3;   // quantile of the surrounding values; vessels occupy the smaller part

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
double resemblanceOfPairs(int darker)
{
    const double fraction = static_cast<double>(darker) / directions;
    return std::clamp((fraction - minPairFraction) / (fullPairFraction - minPairFraction), 0.0, 1.0);
}

}   // namespace

TubeDetector::TubeDetector(const Volume& volume, double widestRadiusMm) : volume_(volume)
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

double TubeDetector::valueAt(const Eigen::Vector3i& voxel) const
{
    const Eigen::Vector3i inside = voxel.cwiseMax(0).cwiseMin((volume_.geometry.size.array() - 1).matrix());
    return volume_.value(volume_.geometry.index(inside.x(), inside.y(), inside.z()));
}

/// Returns the number of pairs with both values ≤ `limit`; 0 as soon as `atLeast` pairs can no longer be reached.
int TubeDetector::countDarkerPairs(const Shell& shell, const Eigen::Vector3i& voxel, double limit, int atLeast) const
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

TubeResemblance TubeDetector::tube(const Eigen::Vector3i& voxel, double tissue) const
{
    const double here = valueAt(voxel);
    const double drop = minRelativeDrop * (here - tissue);
    if (drop <= 0.0) {
        return {};
    }
    TubeResemblance look;
    int maxPairs = 0;
    for (const Shell& shell : shells_) {
        if (const int count = countDarkerPairs(shell, voxel, here - drop, maxPairs + 1); count > maxPairs) {
            maxPairs = count;
            look.shellMm = shell.radiusMm;
        }
    }
    look.fraction = resemblanceOfPairs(maxPairs);
    return look;
}

double TubeDetector::tubeResemblance(const Eigen::Vector3i& voxel, double tissue) const
{
    const double here = valueAt(voxel);
    const double drop = minRelativeDrop * (here - tissue);
    if (drop <= 0.0) {
        return 0.0;
    }
    const int minPairs = static_cast<int>(std::floor(minPairFraction * directions)) + 1;
    int maxPairs = 0;
    for (const Shell& shell : shells_) {
        maxPairs = std::max(maxPairs, countDarkerPairs(shell, voxel, here - drop, std::max(maxPairs + 1, minPairs)));
        if (resemblanceOfPairs(maxPairs) >= 1.0) {
            break;
        }
    }
    return resemblanceOfPairs(maxPairs);
}

std::vector<double> TubeDetector::valuesAround(const Eigen::Vector3i& voxel, double distanceMm) const
{
    std::vector<double> values;
    for (const Eigen::Vector3i& step : halfShell(distanceMm, volume_.geometry.spacingMm)) {
        values.push_back(valueAt(voxel + step));
        values.push_back(valueAt(voxel - step));
    }
    return values;
}

VesselAppearance TubeDetector::appearanceAt(const Eigen::Vector3i& voxel) const
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
    const auto atQuantile =
        around.begin() + static_cast<std::ptrdiff_t>(tissueQuantile * static_cast<double>(around.size() - 1));
    std::nth_element(around.begin(), atQuantile, around.end());
    return {valueAt(voxel), *atQuantile};
}

Eigen::Vector3i TubeDetector::bestVoxelNear(const Eigen::Vector3i& voxel, double reachMm) const
{
    const Eigen::Vector3d& spacing = volume_.geometry.spacingMm;
    const Eigen::Vector3i reach = (reachMm * spacing.cwiseInverse()).array().floor().cast<int>();
    const double tissue = appearanceAt(voxel).tissue;
    double best = -std::numeric_limits<double>::infinity();
    Eigen::Vector3i bestVoxel = voxel;
    for (int k = -reach.z(); k <= reach.z(); ++k) {
        for (int j = -reach.y(); j <= reach.y(); ++j) {
            for (int i = -reach.x(); i <= reach.x(); ++i) {
                const Eigen::Vector3i at = voxel + Eigen::Vector3i(i, j, k);
                const double awayMm = Eigen::Vector3d(i, j, k).cwiseProduct(spacing).norm();
                if (awayMm > reachMm || !volume_.geometry.contains(at)) {
                    continue;
                }
                const double score =
                    (valueAt(at) - tissue) * (0.3 + tube(at, tissue).fraction) * (1.0 - 0.5 * awayMm / reachMm);
                if (score > best) {
                    best = score;
                    bestVoxel = at;
                }
            }
        }
    }
    return bestVoxel;
}

}   // namespace angiopose::core
