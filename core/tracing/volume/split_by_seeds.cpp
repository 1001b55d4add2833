#include "core/tracing/volume/split_by_seeds.h"

#include "core/support/parallel_for.h"
#include "core/tracing/volume/chambers.h"
#include "core/tracing/volume/chosen_pieces.h"
#include "core/tracing/volume/distance_map.h"
#include "core/tracing/volume/necks.h"

#include <algorithm>
#include <array>
#include <queue>

namespace core {
namespace {

constexpr std::uint8_t unreached = 1;
constexpr std::uint8_t vessel = 2;
constexpr std::uint8_t other = 3;

/// A voxel that is next to flooded ones: the widest comes first, of equal ones the earliest.
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

    /// Places off a vessel's middle stand for it: else a wider neighbour would be there first.
    void start(const std::vector<Eigen::Vector3d>& placesInPatient, std::uint8_t label)
    {
        for (const Eigen::Vector3d& place : placesInPatient) {
            if (const auto voxel = voxelNear(mask_, place)) {
                start(wayToMiddle(*voxel, distances_), label);
            }
        }
    }

    /// Markers are flooded at once, where nothing is yet.
    void start(const std::vector<std::uint32_t>& voxels, std::uint8_t label)
    {
        for (const std::uint32_t voxel : voxels) {
            if (mask_.voxels[voxel] == unreached) {
                mask_.voxels[voxel] = label;
                pushNeighbours(voxel, label);
            }
        }
    }

    void run(TracingProgress& progress)
    {
        while (!shores_.empty()) {
            const Shore shore = shores_.top();
            shores_.pop();
            if (mask_.voxels[shore.voxel] != unreached) {
                continue;
            }
            mask_.voxels[shore.voxel] = shore.label;
            if ((turn_ & 0xFFFU) == 0 && !progress.advance(0.5)) {
                return;
            }
            pushNeighbours(shore.voxel, shore.label);
        }
    }

private:
    void push(std::uint32_t voxel, std::uint8_t label)
    {
        shores_.push({distances_.units[voxel], turn_++, voxel, label});
    }

    void pushNeighbours(std::uint32_t from, std::uint8_t label)
    {
        const Eigen::Vector3i& size = mask_.geometry.size;
        const auto at = static_cast<std::int64_t>(from);
        const Eigen::Vector3i voxel(static_cast<int>(at % size.x()), static_cast<int>(at / size.x() % size.y()),
                                    static_cast<int>(at / (static_cast<std::int64_t>(size.x()) * size.y())));
        for (int z = -1; z <= 1; ++z) {
            for (int y = -1; y <= 1; ++y) {
                for (int x = -1; x <= 1; ++x) {
                    const Eigen::Vector3i next = voxel + Eigen::Vector3i(x, y, z);
                    if (mask_.geometry.contains(next) && mask_.at(next.x(), next.y(), next.z()) == unreached) {
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

}   // namespace

void splitBySeeds(VoxelMask& mask, const VesselTracingOptions& options, const VoxelFill& fill,
                  TracingProgress& progress)
{
    for (std::uint8_t& voxel : mask.voxels) {
        voxel = voxel != 0 ? unreached : 0;
    }
    const DistanceMap distances = distanceMap(mask, threadCount(options.threads), progress);
    const Necks necks = necksOf(mask, distances, options.seedsInPatient, progress);
    if (progress.isStopped()) {
        return;
    }
    Flood flood(mask, distances);
    flood.start(options.seedsInPatient, vessel);
    flood.start(options.avoidInPatient, other);
    flood.start(voxelsBeyondNecks(distances, necks), other);
    if (fill) {
        flood.start(voxelsOfOtherBlood(distances, necks.units, fill), other);
    }
    flood.run(progress);
    for (std::uint8_t& voxel : mask.voxels) {
        voxel = voxel == vessel ? 1 : 0;
    }
}

}   // namespace core
