#include "core/tracing/volume/path/cheapest_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>

namespace angiopose::core {
namespace {

constexpr double leastMarginMm = 15.0;   // of the searched part, around both ends
constexpr double mostMarginMm = 40.0;
constexpr double marginPerWay = 0.35;
constexpr std::size_t mostSearchedVoxels = 64'000'000;
constexpr std::size_t mostSettled = 3'000'000;
constexpr std::size_t settledPerReport = 4096;
constexpr std::uint8_t notReached = 255;
constexpr float unknown = -1.0F;

/// A step to one of the 26 neighbours.
struct NeighbourStep {
    Eigen::Vector3i way;
    float lengthMm;
};

std::array<NeighbourStep, 27> neighbourSteps(const Eigen::Vector3d& spacingMm)
{
    std::array<NeighbourStep, 27> steps;
    for (int n = 0; n < 27; ++n) {
        const Eigen::Vector3i way(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
        steps[static_cast<std::size_t>(n)] = {way,
                                              static_cast<float>(way.cast<double>().cwiseProduct(spacingMm).norm())};
    }
    return steps;
}

/// The searched part of a grid.
struct SearchedPart {
    Eigen::Vector3i first = Eigen::Vector3i::Zero();
    VolumeGeometry grid;   ///< its size and spacing

    SearchedPart(const VolumeGeometry& whole, const Eigen::Vector3i& from, const Eigen::Vector3i& to)
    {
        const double wayMm = (to - from).cast<double>().cwiseProduct(whole.spacingMm).norm();
        const double marginMm = std::clamp(marginPerWay * wayMm, leastMarginMm, mostMarginMm);
        const Eigen::Vector3i margin = (marginMm * whole.spacingMm.cwiseInverse()).array().ceil().cast<int>();
        first = (from.cwiseMin(to) - margin).cwiseMax(0);
        const Eigen::Vector3i last = (from.cwiseMax(to) + margin).cwiseMin((whole.size.array() - 1).matrix());
        grid.size = last - first + Eigen::Vector3i::Ones();
        grid.spacingMm = whole.spacingMm;
    }
    std::size_t index(const Eigen::Vector3i& voxel) const
    {
        const Eigen::Vector3i at = voxel - first;
        return grid.index(at.x(), at.y(), at.z());
    }
    Eigen::Vector3i voxelAt(std::size_t index) const { return grid.voxelAt(index) + first; }
    bool contains(const Eigen::Vector3i& voxel) const { return grid.contains(voxel - first); }
};

struct Waiting {
    float cost;
    std::uint32_t voxel;
    bool operator>(const Waiting& other) const { return cost > other.cost; }
};

/// One search from a voxel over the part.
class PathSearch {
public:
    PathSearch(const SearchedPart& part, const VoxelCost& costOf)
        : part_(part),
          costOf_(costOf),
          steps_(neighbourSteps(part.grid.spacingMm)),
          distance_(part.grid.voxelCount(), std::numeric_limits<float>::infinity()),
          costs_(part.grid.voxelCount(), unknown),
          arrival_(part.grid.voxelCount(), notReached)
    {
    }

    bool search(const Eigen::Vector3i& from, const Eigen::Vector3i& to, TracingProgress& progress)
    {
        const auto goal = static_cast<std::uint32_t>(part_.index(to));
        distance_[part_.index(from)] = 0.0F;
        waiting_.push({0.0F, static_cast<std::uint32_t>(part_.index(from))});
        for (std::size_t settled = 0; !waiting_.empty() && settled < mostSettled;) {
            const Waiting next = waiting_.top();
            waiting_.pop();
            if (next.cost > distance_[next.voxel]) {
                continue;   // came on a cheaper way since
            }
            if (next.voxel == goal) {
                return true;
            }
            settle(next.voxel);
            if (++settled % settledPerReport == 0 &&
                !progress.advance(static_cast<double>(settled) / static_cast<double>(mostSettled))) {
                return false;
            }
        }
        return false;
    }

    std::vector<Eigen::Vector3i> wayTo(const Eigen::Vector3i& to) const
    {
        std::vector<Eigen::Vector3i> way{to};
        while (arrival_[part_.index(way.back())] != notReached) {
            way.push_back(way.back() - steps_[arrival_[part_.index(way.back())]].way);
        }
        std::ranges::reverse(way);
        return way;
    }

private:
    float costAt(const Eigen::Vector3i& voxel, std::size_t index)
    {
        if (costs_[index] == unknown) {
            costs_[index] = static_cast<float>(costOf_(voxel));
        }
        return costs_[index];
    }

    void settle(std::uint32_t index)
    {
        const Eigen::Vector3i voxel = part_.voxelAt(index);
        const float here = costAt(voxel, index);
        for (std::size_t n = 0; n < steps_.size(); ++n) {
            const Eigen::Vector3i at = voxel + steps_[n].way;
            if (!part_.contains(at) || steps_[n].lengthMm == 0.0F) {
                continue;
            }
            const std::size_t there = part_.index(at);
            if (distance_[there] <= distance_[index]) {
                continue;   // settled, or as near already
            }
            const float cost = distance_[index] + 0.5F * (here + costAt(at, there)) * steps_[n].lengthMm;
            if (cost < distance_[there]) {
                distance_[there] = cost;
                arrival_[there] = static_cast<std::uint8_t>(n);
                waiting_.push({cost, static_cast<std::uint32_t>(there)});
            }
        }
    }

    const SearchedPart& part_;
    const VoxelCost& costOf_;
    std::array<NeighbourStep, 27> steps_;
    std::vector<float> distance_;
    std::vector<float> costs_;
    std::vector<std::uint8_t> arrival_;   ///< the step that led here
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting_;
};

}   // namespace

std::vector<Eigen::Vector3i> cheapestPath(const VolumeGeometry& grid, const Eigen::Vector3i& from,
                                          const Eigen::Vector3i& to, const VoxelCost& costOf, TracingProgress& progress)
{
    const SearchedPart part(grid, from, to);
    if (part.grid.voxelCount() > mostSearchedVoxels) {
        return {};
    }
    PathSearch search(part, costOf);
    return search.search(from, to, progress) ? search.wayTo(to) : std::vector<Eigen::Vector3i>();
}

}   // namespace angiopose::core
