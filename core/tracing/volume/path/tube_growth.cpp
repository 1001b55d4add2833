#include "core/tracing/volume/path/tube_growth.h"

#include "core/support/quantile.h"
#include "core/tracing/volume/path/voxel_cost.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <unordered_map>

namespace angiopose::core {
namespace {

// Maximum cost per millimeter (see `costOfVoxel`) of a tube voxel, corresponding to 0.7 of the lumen contrast and half
// a tube; a higher cost adds to the path's debt.
constexpr double tubeCost = 3.3;
constexpr double maxDebt = 9.0;   // about 3 mm through a chamber or a quarter of a millimeter through tissue
constexpr double debtReduction = 0.5;   // fraction of the cost saved in tube voxels that reduces the debt
constexpr double adaptationMm = 12.0;   // length over which the expected appearance adapts to the path
constexpr double fadingMm = 100.0;   // length over which the contrast of an artery fades
constexpr double minArteryContrast = 0.6;   // minimum relative contrast; a later-opacified vein has less
constexpr double radiusInShell = 0.35;   // lower limit of the radius, relative to the shell
constexpr double blurInVoxels = 1.0;
constexpr std::size_t maxGrownVoxels = 2'000'000;
constexpr std::size_t voxelsPerReport = 4096;
constexpr double radiusPerShell = 0.75;   // assumed radius relative to the darker shell, which lies outside the wall
constexpr int noBranch = -1;

/// State of a path at a voxel.
struct ReachedVoxel {
    double cost = std::numeric_limits<double>::infinity();
    double pathLengthMm = 0.0;   ///< distance from the seed
    double debt = 0.0;
    VesselAppearance appearance;
    double undimmedBlood = 0.0;   ///< lumen level of the vessel without dimming by blurring
    std::size_t previous = 0;   ///< previous voxel; for a seed the voxel itself
    bool isTube = false;
    bool isSettled = false;
    int branch = noBranch;   ///< branch whose lumen contains the voxel
    std::size_t axis = 0;   ///< nearest centerline voxel of that branch
    bool isTooShort = false;   ///< a path through this voxel was too short for a branch
};

struct QueuedTubeVoxel {
    double cost;
    std::size_t voxel;
    bool operator>(const QueuedTubeVoxel& other) const { return cost > other.cost; }
};

class TubeGrowth {
public:
    TubeGrowth(const TubeDetector& detector, const TubeLimits& limits)
        : detector_(detector), grid_(detector.volume().geometry), limits_(limits)
    {
    }

    bool grow(const std::vector<Eigen::Vector3i>& seeds, TracingProgress& progress)
    {
        for (const Eigen::Vector3i& seed : seeds) {
            const std::size_t voxel = indexOf(seed);
            const VesselAppearance appearance = detector_.appearanceAt(seed);
            reached_[voxel] = {0.0, 0.0, 0.0, appearance, appearance.blood, voxel, true};
            waiting_.push({0.0, voxel});
        }
        for (settled_ = 0; !waiting_.empty() && settled_ < maxGrownVoxels;) {
            const QueuedTubeVoxel next = waiting_.top();
            waiting_.pop();
            ReachedVoxel& here = reached_.at(next.voxel);
            if (here.isSettled || next.cost > here.cost) {
                continue;
            }
            here.isSettled = true;
            expand(next.voxel, here);
            if (++settled_ % voxelsPerReport == 0 &&
                !progress.advance(static_cast<double>(settled_) / static_cast<double>(maxGrownVoxels))) {
                return false;
            }
        }
        return true;
    }

    bool isTruncated() const { return settled_ >= maxGrownVoxels; }

    /// Builds branches from the ends of tubes, longest path first.
    std::vector<BranchPath> branches()
    {
        std::vector<std::size_t> ends;
        for (const auto& [voxel, here] : reached_) {
            if (here.isSettled && here.isTube) {
                ends.push_back(voxel);
            }
        }
        std::ranges::sort(ends, [&](std::size_t a, std::size_t b) {
            const double lengthA = reached_.at(a).pathLengthMm;
            const double lengthB = reached_.at(b).pathLengthMm;
            return lengthA != lengthB ? lengthA > lengthB : a < b;
        });
        std::vector<BranchPath> paths;
        for (const std::size_t end : ends) {
            addBranch(end, paths);
        }
        return paths;
    }

    VesselAppearance appearance() const
    {
        std::vector<double> bloods;
        std::vector<double> tissues;
        for (const auto& [voxel, here] : reached_) {
            if (here.isSettled && here.branch != noBranch) {
                bloods.push_back(here.appearance.blood);
                tissues.push_back(here.appearance.tissue);
            }
        }
        return bloods.empty() ? VesselAppearance() : VesselAppearance{medianOf(bloods), medianOf(tissues)};
    }

private:
    std::size_t indexOf(const Eigen::Vector3i& voxel) const { return grid_.index(voxel.x(), voxel.y(), voxel.z()); }
    Eigen::Vector3d placeMm(std::size_t voxel) const
    {
        return grid_.voxelAt(voxel).cast<double>().cwiseProduct(grid_.spacingMm);
    }

    void expand(std::size_t from, const ReachedVoxel& here)
    {
        const Eigen::Vector3i voxel = grid_.voxelAt(from);
        for (int n = 0; n < 27; ++n) {
            const Eigen::Vector3i way(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
            if (way != Eigen::Vector3i::Zero() && grid_.contains(voxel + way)) {
                reach(voxel + way, from, here, way.cast<double>().cwiseProduct(grid_.spacingMm).norm());
            }
        }
    }

    /// Returns the cost per mm at a voxel. A darker tube that is too wide to be dimmed by blurring is a vein.
    double costAt(const Eigen::Vector3i& voxel, const ReachedVoxel& here) const
    {
        const double value = detector_.valueAt(voxel);
        const TubeResemblance tube = detector_.tube(voxel, here.appearance.tissue);
        const double height =
            (value - here.appearance.tissue) / std::max(1.0, here.undimmedBlood - here.appearance.tissue);
        if (height < minArteryContrast * relativeContrast(tube.shellMm)) {
            return costOfTube(value, 0.0, {here.undimmedBlood, here.appearance.tissue});
        }
        return costOfTube(value, tube.fraction, here.appearance);
    }

    /// Returns the fraction of the contrast that blurring leaves at the center of a tube with walls within `shellMm`.
    double relativeContrast(double shellMm) const
    {
        const double radiusInBlur = radiusInShell * shellMm / (blurInVoxels * std::cbrt(grid_.spacingMm.prod()));
        return 1.0 - std::exp(-0.5 * radiusInBlur * radiusInBlur);
    }

    void reach(const Eigen::Vector3i& voxel, std::size_t from, const ReachedVoxel& here, double stepMm)
    {
        ReachedVoxel& neighbor = reached_[indexOf(voxel)];
        if (neighbor.isSettled || neighbor.cost <= here.cost) {
            return;
        }
        const double perMm = costAt(voxel, here);
        const double debt =
            std::max(0.0, here.debt + (perMm - tubeCost) * stepMm * (perMm < tubeCost ? debtReduction : 1.0));
        const double cost = here.cost + perMm * stepMm;
        if (debt > maxDebt || cost >= neighbor.cost) {
            return;
        }
        const bool isTube = perMm <= tubeCost;
        const double fraction = isTube ? 1.0 - std::exp(-stepMm / adaptationMm) : 0.0;
        const double value = std::max(detector_.volume().value(indexOf(voxel)), here.appearance.tissue + 1.0);
        neighbor = {cost, here.pathLengthMm + stepMm, debt, here.appearance, here.undimmedBlood, from, isTube};
        neighbor.appearance.blood += fraction * (value - here.appearance.blood);
        const double fading = value > here.undimmedBlood ? fraction : isTube ? 1.0 - std::exp(-stepMm / fadingMm) : 0.0;
        neighbor.undimmedBlood += fading * (value - here.undimmedBlood);
        waiting_.push({cost, indexOf(voxel)});
    }

    /// Traces the path back from an end to a branch or seed, and adds the path if it is long enough for a branch.
    void addBranch(std::size_t end, std::vector<BranchPath>& paths)
    {
        std::vector<std::size_t> way{end};
        while (reached_.at(way.back()).branch == noBranch && reached_.at(way.back()).previous != way.back()) {
            if (reached_.at(way.back()).isTooShort) {
                return;   // a longer path through this voxel was already too short
            }
            way.push_back(reached_.at(way.back()).previous);
        }
        const ReachedVoxel& start = reached_.at(way.back());
        if (reached_.at(end).pathLengthMm - start.pathLengthMm < limits_.minBranchLengthMm + limits_.assumedRadiusMm) {
            for (const std::size_t voxel : way) {
                ReachedVoxel& on = reached_.at(voxel);
                on.isTooShort = on.branch == noBranch;
            }
            return;
        }
        BranchPath path;
        path.parent = start.branch;
        path.generation = start.branch == noBranch ? 0 : paths[static_cast<std::size_t>(start.branch)].generation + 1;
        if (start.branch != noBranch) {
            way.back() = start.axis;   // starts on the centerline of the parent branch
        }
        std::ranges::reverse(way);
        for (const std::size_t voxel : way) {
            path.pointsMm.push_back(placeMm(voxel));
            path.radiusMm.push_back(radiusPerShell * tubeRadiusMm(voxel));
        }
        for (std::size_t n = 0; n < way.size(); ++n) {
            assignToBranch(way[n], tubeRadiusMm(way[n]), static_cast<int>(paths.size()));
        }
        paths.push_back(std::move(path));
    }

    /// Assigns the voxels within the tube around a voxel of a branch to that branch.
    void assignToBranch(std::size_t voxel, double radiusMm, int branch)
    {
        const Eigen::Vector3i middle = grid_.voxelAt(voxel);
        const Eigen::Vector3i reach = (radiusMm * grid_.spacingMm.cwiseInverse()).array().ceil().cast<int>();
        for (int k = -reach.z(); k <= reach.z(); ++k) {
            for (int j = -reach.y(); j <= reach.y(); ++j) {
                for (int i = -reach.x(); i <= reach.x(); ++i) {
                    const Eigen::Vector3i at = middle + Eigen::Vector3i(i, j, k);
                    const double awayMm = Eigen::Vector3d(i, j, k).cwiseProduct(grid_.spacingMm).norm();
                    if (awayMm > radiusMm || !grid_.contains(at)) {
                        continue;
                    }
                    const auto found = reached_.find(indexOf(at));
                    if (found != reached_.end() && found->second.branch == noBranch) {
                        found->second.branch = branch;
                        found->second.axis = voxel;
                    }
                }
            }
        }
    }

    double tubeRadiusMm(std::size_t voxel) const
    {
        const double shellMm = detector_.tube(grid_.voxelAt(voxel), reached_.at(voxel).appearance.tissue).shellMm;
        return std::clamp(shellMm, grid_.spacingMm.maxCoeff(), maxTubeRadiusMm);
    }

    const TubeDetector& detector_;
    const VolumeGeometry& grid_;
    TubeLimits limits_;
    std::unordered_map<std::size_t, ReachedVoxel> reached_;
    std::priority_queue<QueuedTubeVoxel, std::vector<QueuedTubeVoxel>, std::greater<>> waiting_;
    std::size_t settled_ = 0;
};

}   // namespace

TubePaths growTubes(const TubeDetector& detector, const std::vector<Eigen::Vector3i>& seeds, const TubeLimits& limits,
                    TracingProgress& progress)
{
    TubeGrowth growth(detector, limits);
    if (!growth.grow(seeds, progress)) {
        return {};
    }
    TubePaths grown;
    grown.paths = growth.branches();
    grown.appearance = growth.appearance();
    grown.isTruncated = growth.isTruncated();
    return grown;
}

}   // namespace angiopose::core
