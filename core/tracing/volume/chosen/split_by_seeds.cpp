#include "core/tracing/volume/chosen/split_by_seeds.h"

#include "core/support/parallel_for.h"
#include "core/tracing/volume/chosen/chambers.h"
#include "core/tracing/volume/great_vessels/necks.h"
#include "core/tracing/volume/voxels/chosen_pieces.h"
#include "core/tracing/volume/voxels/distance_map.h"

#include <algorithm>
#include <array>
#include <queue>

namespace angiopose::core {
namespace {

constexpr std::uint8_t unreachedVoxel = 1;
constexpr std::uint8_t vessel = 2;
constexpr std::uint8_t other = 3;
constexpr double maxBallBeyondSection = 1.3;   ///< maximum inscribed sphere relative to the cross-section
constexpr double minNeckFromSeed =
    0.45;   ///< minimum neck toward the great vessel that continues a seeded vessel, relative to the thinner radius

/// Voxel at the front of the flood; the widest is processed first, ties in order of insertion.
struct Shore {
    std::uint16_t width = 0;
    std::uint32_t turn = 0;
    std::uint32_t voxel = 0;
    std::uint8_t label = 0;

    bool operator<(const Shore& later) const { return width != later.width ? width < later.width : turn > later.turn; }
};

class Flood {
public:
    Flood(VoxelMask& mask, const DistanceMap& distances) : mask_(mask), distances_(distances) {}

    /// Floods from the center of the vessel even if a start point is off-center; otherwise, a wider adjacent region
    /// would reach the center first.
    void start(const std::vector<Eigen::Vector3d>& placesInPatient, std::uint8_t label)
    {
        for (const Eigen::Vector3d& place : placesInPatient) {
            if (const auto voxel = voxelNear(mask_, place)) {
                start(wayToMiddle(*voxel, distances_), label);
            }
        }
    }

    /// Labels markers immediately unless they already have a label.
    void start(const std::vector<std::uint32_t>& voxels, std::uint8_t label)
    {
        for (const std::uint32_t voxel : voxels) {
            if (mask_.voxels[voxel] == unreachedVoxel) {
                mask_.voxels[voxel] = label;
                pushNeighbors(voxel, label);
            }
        }
    }

    void run(TracingProgress& progress)
    {
        while (!shores_.empty()) {
            const Shore shore = shores_.top();
            shores_.pop();
            if (mask_.voxels[shore.voxel] != unreachedVoxel) {
                continue;
            }
            mask_.voxels[shore.voxel] = shore.label;
            if ((turn_ & 0xFFFU) == 0 && !progress.advance(0.5)) {
                return;
            }
            pushNeighbors(shore.voxel, shore.label);
        }
    }

private:
    void push(std::uint32_t voxel, std::uint8_t label)
    {
        shores_.push({distances_.units[voxel], turn_++, voxel, label});
    }

    void pushNeighbors(std::uint32_t from, std::uint8_t label)
    {
        const Eigen::Vector3i voxel = mask_.geometry.voxelAt(from);
        for (int z = -1; z <= 1; ++z) {
            for (int y = -1; y <= 1; ++y) {
                for (int x = -1; x <= 1; ++x) {
                    const Eigen::Vector3i next = voxel + Eigen::Vector3i(x, y, z);
                    if (mask_.geometry.contains(next) && mask_.at(next.x(), next.y(), next.z()) == unreachedVoxel) {
                        push(static_cast<std::uint32_t>(mask_.geometry.index(next.x(), next.y(), next.z())), label);
                    }
                }
            }
        }
    }

    VoxelMask& mask_;
    const DistanceMap& distances_;
    std::priority_queue<Shore> shores_;
    std::uint32_t turn_ = 0;
};

/// Finds the region that belongs to given start points; reusable for the same mask.
class Splitter {
public:
    Splitter(VoxelMask& mask, const VesselTracingOptions& options, const VoxelFill& fill, TracingProgress& progress)
        : mask_(mask),
          options_(options),
          fill_(fill),
          progress_(progress),
          distances_(distanceMap(mask, threadCount(options.threads), progress))
    {
    }

    /// Labels the region that belongs to these start points.
    void split(const std::vector<Eigen::Vector3d>& startsInPatient)
    {
        for (std::uint8_t& voxel : mask_.voxels) {
            voxel = voxel != 0 ? unreachedVoxel : 0;
        }
        necks_ = necksOf(mask_, distances_, startsInPatient, progress_);
        if (progress_.isStopped()) {
            return;
        }
        Flood flood(mask_, distances_);
        flood.start(startsInPatient, vessel);
        flood.start(options_.avoidInPatient, other);
        flood.start(voxelsBeyondNecks(distances_, necks_), other);
        if (fill_) {
            flood.start(voxelsOfOtherBlood(distances_, necks_.units, fill_), other);
        }
        flood.run(progress_);
    }

    /// Returns whether the labeled vessel contains a point; valid after `split`.
    bool holds(const Eigen::Vector3d& placeInPatient) const
    {
        const auto voxel = voxelNear(mask_, placeInPatient);
        return voxel && mask_.voxels[*voxel] == vessel;
    }

    /// Labels the region of the first great vessel that contains the seed, or else of the seed itself; returns the
    /// start points used.
    std::vector<Eigen::Vector3d> splitFor(const Eigen::Vector3d& seed, const std::vector<GreatVessel>& greatVessels)
    {
        const auto around = std::find_if(greatVessels.begin(), greatVessels.end(),
                                         [&](const GreatVessel& great) { return great.surrounds(seed); });
        if (around != greatVessels.end()) {
            std::vector<Eigen::Vector3d> points = middlesOf(*around);
            split(points);
            if (holds(seed)) {
                return points;
            }
        }
        split({seed});
        std::vector<Eigen::Vector3d> points = continuedIn(greatVessels);
        if (points.empty()) {
            return {seed};
        }
        split(points);
        if (!holds(seed)) {   // the seeded vessel is wider than the detected section
            points.push_back(seed);
            split(points);
        }
        return points;
    }

    /// Returns the axis points of the great vessel in this mask, except those from which steepest ascent in the
    /// distance map leads into a wider touching structure.
    std::vector<Eigen::Vector3d> middlesOf(const GreatVessel& great) const
    {
        std::vector<Eigen::Vector3d> middles;
        for (const Trunk& trunk : great.trunks) {
            for (std::size_t n = 0; n < trunk.radiusMm.size(); ++n) {
                const auto voxel = voxelNear(mask_, trunk.pointsInPatient[n]);
                if (voxel &&
                    distances_.mm(wayToMiddle(*voxel, distances_).back()) <= maxBallBeyondSection * trunk.radiusMm[n]) {
                    middles.push_back(trunk.pointsInPatient[n]);
                }
            }
        }
        return middles;
    }

private:
    /// Returns the points of the first great vessel that the seed reaches along a path about as wide as that vessel and
    /// the seed's vessel; empty if there is none. Valid after `split` for a seed.
    std::vector<Eigen::Vector3d> continuedIn(const std::vector<GreatVessel>& greatVessels) const
    {
        for (const GreatVessel& great : greatVessels) {
            std::vector<Eigen::Vector3d> points = middlesOf(great);
            const auto held = std::count_if(points.begin(), points.end(), [this](const auto& p) { return holds(p); });
            if (2 * held >= static_cast<std::ptrdiff_t>(points.size()) && isContinuedIn(points)) {
                return points;
            }
        }
        return {};
    }

    bool isContinuedIn(const std::vector<Eigen::Vector3d>& points) const
    {
        return std::any_of(points.begin(), points.end(), [this](const Eigen::Vector3d& point) {
            const std::uint32_t middle = wayToMiddle(*voxelNear(mask_, point), distances_).back();
            return distances_.unitMm * necks_.units[middle] >=
                   minNeckFromSeed * std::min(necks_.seedRadiusMm, distances_.mm(middle));
        });
    }

    VoxelMask& mask_;
    const VesselTracingOptions& options_;
    const VoxelFill& fill_;
    TracingProgress& progress_;
    DistanceMap distances_;
    Necks necks_;   ///< necks of the last split
};

}   // namespace

std::vector<Eigen::Vector3d> splitBySeeds(VoxelMask& mask, const VesselTracingOptions& options, const VoxelFill& fill,
                                          const std::vector<GreatVessel>& greatVessels, TracingProgress& progress)
{
    Splitter splitter(mask, options, fill, progress);
    std::vector<Eigen::Vector3d> starts;
    if (options.seedsInPatient.empty() && !greatVessels.empty()) {
        const std::size_t count = options.pieces == TracedPieces::All ? greatVessels.size() : 1;
        for (std::size_t n = 0; n < count; ++n) {
            const std::vector<Eigen::Vector3d> its = splitter.middlesOf(greatVessels[n]);
            starts.insert(starts.end(), its.begin(), its.end());
        }
        starts = starts.empty() ? std::vector{greatVessels.front().middleInPatient()} : starts;
        splitter.split(starts);
    }
    for (const Eigen::Vector3d& seed : options.seedsInPatient) {
        if (!starts.empty() && splitter.holds(seed)) {
            continue;
        }
        const std::vector<Eigen::Vector3d> its = splitter.splitFor(seed, greatVessels);
        const bool isFirst = starts.empty();
        starts.insert(starts.end(), its.begin(), its.end());
        if (!isFirst) {
            splitter.split(starts);
        }
    }
    for (std::uint8_t& voxel : mask.voxels) {
        voxel = voxel == vessel ? 1 : 0;
    }
    return starts;
}

}   // namespace angiopose::core
