#include "core/tracing/volume/chambers.h"

#include "core/tracing/volume/chosen_pieces.h"

#include <algorithm>
#include <queue>

namespace core {
namespace {

constexpr double leastSeedRadiusMm = 5.0;   ///< thinner vessels say nothing about how wide their trunk is
constexpr double leastChamberRadiusMm = 4.0;   ///< thinner leaks are left to pruning
constexpr double leastNeckShare = 0.3;   ///< of the radius beyond it: stenoses and compressed lumens are wider
constexpr double mostChamberShare = 1.35;   ///< of the radius at the seed

template <class Visit>
void eachNeighbour(const VolumeGeometry& grid, std::uint32_t voxel, const Visit& visit)
{
    const Eigen::Vector3i& size = grid.size;
    const auto at = static_cast<std::int64_t>(voxel);
    const Eigen::Vector3i place(static_cast<int>(at % size.x()), static_cast<int>(at / size.x() % size.y()),
                                static_cast<int>(at / (static_cast<std::int64_t>(size.x()) * size.y())));
    for (int z = -1; z <= 1; ++z) {
        for (int y = -1; y <= 1; ++y) {
            for (int x = -1; x <= 1; ++x) {
                const Eigen::Vector3i next = place + Eigen::Vector3i(x, y, z);
                if (grid.contains(next)) {
                    visit(static_cast<std::uint32_t>(grid.index(next.x(), next.y(), next.z())));
                }
            }
        }
    }
}

/// The middle of the vessel around a voxel: the way up the distances.
std::uint32_t widestFrom(std::uint32_t voxel, const DistanceMap& distances)
{
    for (;;) {
        std::uint32_t best = voxel;
        eachNeighbour(distances.geometry, voxel, [&](std::uint32_t next) {
            if (distances.units[next] > distances.units[best]) {
                best = next;
            }
        });
        if (best == voxel) {
            return voxel;
        }
        voxel = best;
    }
}

/// For each voxel the narrowest place on the widest way to it from any seed, in the units of the distances.
std::vector<std::uint16_t> necks(const DistanceMap& distances, const std::vector<std::uint32_t>& seeds,
                                 TracingProgress& progress)
{
    struct Shore {
        std::uint16_t neck = 0;
        std::uint32_t voxel = 0;

        bool operator<(const Shore& wider) const { return neck < wider.neck; }
    };
    std::vector<std::uint16_t> neck(distances.units.size(), 0);
    std::priority_queue<Shore> shores;
    const auto reach = [&](std::uint32_t voxel, std::uint16_t width) {
        if (width > neck[voxel]) {
            neck[voxel] = width;
            shores.push({width, voxel});
        }
    };
    for (const std::uint32_t seed : seeds) {
        reach(seed, distances.units[seed]);
    }
    for (std::uint32_t turn = 0; !shores.empty(); ++turn) {
        const Shore shore = shores.top();
        shores.pop();
        if ((turn & 0xFFFU) == 0 && !progress.advance(0.0)) {
            break;
        }
        if (shore.neck == neck[shore.voxel]) {
            eachNeighbour(distances.geometry, shore.voxel,
                          [&](std::uint32_t next) { reach(next, std::min(shore.neck, distances.units[next])); });
        }
    }
    return neck;
}

}   // namespace

std::vector<std::uint32_t> voxelsBeyondNecks(const VoxelMask& mask, const DistanceMap& distances,
                                             const std::vector<Eigen::Vector3d>& seedsInPatient,
                                             TracingProgress& progress)
{
    std::vector<std::uint32_t> seeds;
    double seedRadiusMm = 0.0;
    for (const Eigen::Vector3d& seed : seedsInPatient) {
        if (const auto voxel = voxelNear(mask, seed)) {
            seeds.push_back(widestFrom(*voxel, distances));
            seedRadiusMm = std::max(seedRadiusMm, distances.mm(seeds.back()));
        }
    }
    std::vector<std::uint32_t> beyond;
    if (seedRadiusMm < leastSeedRadiusMm) {
        return beyond;
    }
    const std::vector<std::uint16_t> neck = necks(distances, seeds, progress);
    for (std::uint32_t voxel = 0; voxel < neck.size() && !progress.isStopped(); ++voxel) {
        const double radiusMm = distances.mm(voxel);
        const bool isNarrowNeck = neck[voxel] < leastNeckShare * distances.units[voxel];
        if (radiusMm >= leastChamberRadiusMm && neck[voxel] > 0 &&
            (isNarrowNeck || radiusMm > mostChamberShare * seedRadiusMm)) {
            beyond.push_back(voxel);
        }
    }
    return beyond;
}

}   // namespace core
