#include "core/tracing/volume/path/minimal_path.h"

#include "core/tracing/volume/path/search_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>

namespace angiopose::core {
namespace {

constexpr double minMarginMm = 15.0;   // margin of the search box around both ends
constexpr double maxMarginMm = 40.0;
constexpr double marginPerDistance = 0.35;
constexpr std::size_t settledPerReport = 4096;

/// A step to one of the 26 neighbors.
struct NeighborStep {
    Eigen::Vector3i way;
    float lengthMm;
};

std::array<NeighborStep, 26> neighborSteps(const Eigen::Vector3d& spacingMm)
{
    std::array<NeighborStep, 26> steps;
    for (int n = 0, step = 0; n < 27; ++n) {
        const Eigen::Vector3i way(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
        if (way != Eigen::Vector3i::Zero()) {
            const double lengthMm = way.cast<double>().cwiseProduct(spacingMm).norm();
            steps[static_cast<std::size_t>(step++)] = {way, static_cast<float>(lengthMm)};
        }
    }
    return steps;
}

struct QueuedVoxel {
    float key;   ///< path cost plus half the minimum cost ahead, minus half the minimum cost back
    float distance;
    std::uint32_t voxel;
    bool operator>(const QueuedVoxel& other) const { return key > other.key; }
};

using VoxelQueue = std::priority_queue<QueuedVoxel, std::vector<QueuedVoxel>, std::greater<>>;

/// Bidirectional search within a box of voxels; indices count from the first voxel of the box.
class PathSearch {
public:
    PathSearch(const VolumeGeometry& box, const Eigen::Vector3i& first, const VoxelCost& cost)
        : box_(box), first_(first), cost_(cost), steps_(neighborSteps(box.spacingMm)), cells_(box.size)
    {
    }

    MinimalPath between(const Eigen::Vector3i& from, const Eigen::Vector3i& to, std::size_t maxSettled,
                        TracingProgress& progress)
    {
        ends_ = {from - first_, to - first_};
        for (const std::size_t side : {0U, 1U}) {
            relax(cells_.at(ends_[side]), ends_[side], 0.0F, side);
        }
        for (std::size_t settled = 0; !isFound() && settled < maxSettled;) {
            // Expanding the side with the shorter queue visits fewer voxels.
            settled += settleNext(queues_[0].size() <= queues_[1].size() ? 0 : 1) ? 1 : 0;
            if (settled % settledPerReport == 0 &&
                !progress.advance(static_cast<double>(settled) / static_cast<double>(maxSettled))) {
                return {};
            }
        }
        return isFound() ? MinimalPath{pathThroughMeeting()} : MinimalPath{{}, true};
    }

private:
    /// Returns whether the cheapest path is known: no path over a queued voxel is cheaper, or one side is exhausted.
    bool isFound() const
    {
        return queues_[0].empty() || queues_[1].empty() || queues_[0].top().key + queues_[1].top().key >= lowestCost_;
    }

    void relax(SearchCell& cell, const Eigen::Vector3i& voxel, float distance, std::size_t side)
    {
        cell.distance[side] = distance;
        if (distance + cell.distance[1 - side] < lowestCost_) {
            lowestCost_ = distance + cell.distance[1 - side];
            meetingVoxel_ = voxel;
        }
        const float onward = halfMinCost(voxel, ends_[1 - side]) - halfMinCost(voxel, ends_[side]);
        queues_[side].push(
            {distance + onward, distance, static_cast<std::uint32_t>(box_.index(voxel.x(), voxel.y(), voxel.z()))});
    }

    float halfMinCost(const Eigen::Vector3i& voxel, const Eigen::Vector3i& end) const
    {
        return static_cast<float>(0.5 * cost_.minPerMm *
                                  (voxel - end).cast<double>().cwiseProduct(box_.spacingMm).norm());
    }

    /// Settles the next voxel; returns false if a cheaper path has reached it in the meantime.
    bool settleNext(std::size_t side)
    {
        const QueuedVoxel next = queues_[side].top();
        queues_[side].pop();
        const Eigen::Vector3i voxel = box_.voxelAt(next.voxel);
        SearchCell& here = cells_.at(voxel);
        if (next.distance > here.distance[side]) {
            return false;
        }
        const float perMm = costAt(here, voxel);
        for (std::size_t n = 0; n < steps_.size(); ++n) {
            const Eigen::Vector3i at = voxel + steps_[n].way;
            if (!box_.contains(at)) {
                continue;
            }
            SearchCell& there = cells_.at(at);
            if (there.distance[side] <= next.distance) {
                continue;   // already reached from this side at lower cost
            }
            const float distance = next.distance + 0.5F * (perMm + costAt(there, at)) * steps_[n].lengthMm;
            if (distance < there.distance[side]) {
                there.arrivalStep[side] = static_cast<std::uint8_t>(n);
                relax(there, at, distance, side);
            }
        }
        return true;
    }

    float costAt(SearchCell& cell, const Eigen::Vector3i& voxel) const
    {
        if (cell.perMm == SearchCell::unknown) {
            cell.perMm = static_cast<float>(cost_.perMm(voxel + first_));
        }
        return cell.perMm;
    }

    std::vector<Eigen::Vector3i> pathThroughMeeting()
    {
        if (!std::isfinite(lowestCost_)) {
            return {};
        }
        std::vector<Eigen::Vector3i> way = traceBack(meetingVoxel_, 0);
        std::ranges::reverse(way);
        const std::vector<Eigen::Vector3i> onward = traceBack(meetingVoxel_, 1);
        way.insert(way.end(), onward.begin() + 1, onward.end());
        for (Eigen::Vector3i& voxel : way) {
            voxel += first_;
        }
        return way;
    }

    std::vector<Eigen::Vector3i> traceBack(const Eigen::Vector3i& voxel, std::size_t side)
    {
        std::vector<Eigen::Vector3i> way{voxel};
        while (cells_.at(way.back()).arrivalStep[side] != SearchCell::noArrival) {
            way.push_back(way.back() - steps_[cells_.at(way.back()).arrivalStep[side]].way);
        }
        return way;
    }

    VolumeGeometry box_;
    Eigen::Vector3i first_;
    const VoxelCost& cost_;
    std::array<NeighborStep, 26> steps_;
    SearchCells cells_;
    std::array<Eigen::Vector3i, 2> ends_;
    std::array<VoxelQueue, 2> queues_;
    float lowestCost_ = std::numeric_limits<float>::infinity();   ///< cost of the best path so far
    Eigen::Vector3i meetingVoxel_ = Eigen::Vector3i::Zero();   ///< a voxel on that path
};

}   // namespace

VoxelRange searchRange(const VolumeGeometry& grid, const Eigen::Vector3i& from, const Eigen::Vector3i& to)
{
    const double distanceMm = (to - from).cast<double>().cwiseProduct(grid.spacingMm).norm();
    const double marginMm = std::clamp(marginPerDistance * distanceMm, minMarginMm, maxMarginMm);
    const Eigen::Vector3i margin = (marginMm * grid.spacingMm.cwiseInverse()).array().ceil().cast<int>();
    return {(from.cwiseMin(to) - margin).cwiseMax(0),
            ((from.cwiseMax(to) + margin).array() + 1).matrix().cwiseMin(grid.size)};
}

MinimalPath findMinimalPath(const VolumeGeometry& grid, const Eigen::Vector3i& from, const Eigen::Vector3i& to,
                            const VoxelCost& cost, std::size_t maxSettled, TracingProgress& progress)
{
    const VoxelRange range = searchRange(grid, from, to);
    VolumeGeometry box;
    box.size = range.high - range.low;
    box.spacingMm = grid.spacingMm;
    if (box.voxelCount() > std::numeric_limits<std::uint32_t>::max()) {
        return {{}, true};
    }
    return PathSearch(box, range.low, cost).between(from, to, maxSettled, progress);
}

}   // namespace angiopose::core
