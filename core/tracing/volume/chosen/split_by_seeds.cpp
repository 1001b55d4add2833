#include "core/tracing/volume/chosen/split_by_seeds.h"

#include "core/support/parallel_for.h"
#include "core/tracing/volume/chosen/chambers.h"
#include "core/tracing/volume/great_vessels/necks.h"
#include "core/tracing/volume/voxels/component_selection.h"
#include "core/tracing/volume/voxels/distance_map.h"

#include <algorithm>
#include <array>
#include <queue>

namespace angiopose::core {
namespace {

constexpr std::uint8_t unreachedVoxel = 1;
constexpr std::uint8_t vessel = 2;
constexpr std::uint8_t other = 3;
constexpr double maxSphereToSection = 1.3;   ///< maximum inscribed sphere relative to the cross-section
constexpr double minNeckFromSeed =
    0.45;   ///< minimum neck toward the great vessel that continues a seeded vessel, relative to the thinner radius

/// Voxel at the front of the flood; the widest is processed first, ties in order of insertion.
struct FrontVoxel {
    std::uint16_t width = 0;
    std::uint32_t order = 0;
    std::uint32_t voxel = 0;
    std::uint8_t label = 0;

    bool operator<(const FrontVoxel& later) const
    {
        return width != later.width ? width < later.width : order > later.order;
    }
};

class SeededFlood {
public:
    SeededFlood(VoxelMask& mask, const DistanceMap& distances) : mask_(mask), distances_(distances) {}

    /// Floods from the center of the vessel even if a start point is off-center; otherwise, a wider adjacent region
    /// would reach the center first.
    void start(const std::vector<Eigen::Vector3d>& placesInPatient, std::uint8_t label)
    {
        for (const Eigen::Vector3d& place : placesInPatient) {
            if (const auto voxel = findVoxelNear(mask_, place)) {
                start(pathToCenter(*voxel, distances_), label);
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
        while (!front_.empty()) {
            const FrontVoxel frontVoxel = front_.top();
            front_.pop();
            if (mask_.voxels[frontVoxel.voxel] != unreachedVoxel) {
                continue;
            }
            mask_.voxels[frontVoxel.voxel] = frontVoxel.label;
            if ((nextOrder_ & 0xFFFU) == 0 && !progress.advance(0.5)) {
                return;
            }
            pushNeighbors(frontVoxel.voxel, frontVoxel.label);
        }
    }

private:
    void push(std::uint32_t voxel, std::uint8_t label)
    {
        front_.push({distances_.units[voxel], nextOrder_++, voxel, label});
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
    std::priority_queue<FrontVoxel> front_;
    std::uint32_t nextOrder_ = 0;
};

/// Finds the region that belongs to given start points; reusable for the same mask.
class SeedSplitter {
public:
    SeedSplitter(VoxelMask& mask, const VesselTracingOptions& options, const VoxelOpacification& opacification,
                 TracingProgress& progress)
        : mask_(mask),
          options_(options),
          opacification_(opacification),
          progress_(progress),
          distances_(distanceMap(mask, threadCount(options.threads), progress))
    {
    }

    /// Labels the region that belongs to these start points.
    void split(const std::vector<Eigen::Vector3d>& startPointsInPatient)
    {
        for (std::uint8_t& voxel : mask_.voxels) {
            voxel = voxel != 0 ? unreachedVoxel : 0;
        }
        necks_ = computeNecks(mask_, distances_, startPointsInPatient, progress_);
        if (progress_.isStopped()) {
            return;
        }
        SeededFlood flood(mask_, distances_);
        flood.start(startPointsInPatient, vessel);
        flood.start(options_.avoidInPatient, other);
        flood.start(voxelsBeyondNecks(distances_, necks_), other);
        if (opacification_) {
            flood.start(differentlyOpacifiedVoxels(distances_, necks_.units, opacification_), other);
        }
        flood.run(progress_);
    }

    /// Returns whether the labeled vessel contains a point; valid after `split`.
    bool containsPoint(const Eigen::Vector3d& positionInPatient) const
    {
        const auto voxel = findVoxelNear(mask_, positionInPatient);
        return voxel && mask_.voxels[*voxel] == vessel;
    }

    /// Labels the region of the first great vessel that contains the seed, or else of the seed itself; returns the
    /// start points used.
    std::vector<Eigen::Vector3d> splitFor(const Eigen::Vector3d& seed, const std::vector<GreatVessel>& greatVessels)
    {
        const auto around = std::find_if(greatVessels.begin(), greatVessels.end(),
                                         [&](const GreatVessel& great) { return great.surrounds(seed); });
        if (around != greatVessels.end()) {
            std::vector<Eigen::Vector3d> points = centersOf(*around);
            split(points);
            if (containsPoint(seed)) {
                return points;
            }
        }
        split({seed});
        std::vector<Eigen::Vector3d> points = findContinuation(greatVessels);
        if (points.empty()) {
            return {seed};
        }
        split(points);
        if (!containsPoint(seed)) {   // the seeded vessel is wider than the detected section
            points.push_back(seed);
            split(points);
        }
        return points;
    }

    /// Returns the centerline points of the great vessel in this mask, except those from which steepest ascent in the
    /// distance map leads into a wider touching structure.
    std::vector<Eigen::Vector3d> centersOf(const GreatVessel& great) const
    {
        std::vector<Eigen::Vector3d> centers;
        for (const Trunk& trunk : great.trunks) {
            for (std::size_t n = 0; n < trunk.radiusMm.size(); ++n) {
                const auto voxel = findVoxelNear(mask_, trunk.pointsInPatient[n]);
                if (voxel &&
                    distances_.mm(pathToCenter(*voxel, distances_).back()) <= maxSphereToSection * trunk.radiusMm[n]) {
                    centers.push_back(trunk.pointsInPatient[n]);
                }
            }
        }
        return centers;
    }

private:
    /// Returns the points of the first great vessel that the seed reaches along a path about as wide as that vessel and
    /// the seed's vessel; empty if there is none. Valid after `split` for a seed.
    std::vector<Eigen::Vector3d> findContinuation(const std::vector<GreatVessel>& greatVessels) const
    {
        for (const GreatVessel& great : greatVessels) {
            std::vector<Eigen::Vector3d> points = centersOf(great);
            const auto containedCount =
                std::count_if(points.begin(), points.end(), [this](const auto& p) { return containsPoint(p); });
            if (2 * containedCount >= static_cast<std::ptrdiff_t>(points.size()) && continuesInto(points)) {
                return points;
            }
        }
        return {};
    }

    bool continuesInto(const std::vector<Eigen::Vector3d>& points) const
    {
        return std::any_of(points.begin(), points.end(), [this](const Eigen::Vector3d& point) {
            const std::uint32_t middle = pathToCenter(*findVoxelNear(mask_, point), distances_).back();
            return distances_.unitMm * necks_.units[middle] >=
                   minNeckFromSeed * std::min(necks_.seedRadiusMm, distances_.mm(middle));
        });
    }

    VoxelMask& mask_;
    const VesselTracingOptions& options_;
    const VoxelOpacification& opacification_;
    TracingProgress& progress_;
    DistanceMap distances_;
    Necks necks_;   ///< necks of the last split
};

}   // namespace

std::vector<Eigen::Vector3d> splitBySeeds(VoxelMask& mask, const VesselTracingOptions& options,
                                          const VoxelOpacification& opacification,
                                          const std::vector<GreatVessel>& greatVessels, TracingProgress& progress)
{
    SeedSplitter splitter(mask, options, opacification, progress);
    std::vector<Eigen::Vector3d> starts;
    if (options.seedsInPatient.empty() && !greatVessels.empty()) {
        const std::size_t count = options.pieces == TracedPieces::All ? greatVessels.size() : 1;
        for (std::size_t n = 0; n < count; ++n) {
            const std::vector<Eigen::Vector3d> newStarts = splitter.centersOf(greatVessels[n]);
            starts.insert(starts.end(), newStarts.begin(), newStarts.end());
        }
        starts = starts.empty() ? std::vector{greatVessels.front().centerInPatient()} : starts;
        splitter.split(starts);
    }
    for (const Eigen::Vector3d& seed : options.seedsInPatient) {
        if (!starts.empty() && splitter.containsPoint(seed)) {
            continue;
        }
        const std::vector<Eigen::Vector3d> newStarts = splitter.splitFor(seed, greatVessels);
        const bool isFirst = starts.empty();
        starts.insert(starts.end(), newStarts.begin(), newStarts.end());
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
