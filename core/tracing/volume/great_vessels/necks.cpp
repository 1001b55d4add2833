#include "core/tracing/volume/great_vessels/necks.h"

#include "core/tracing/volume/voxels/component_selection.h"

#include <algorithm>
#include <queue>

namespace angiopose::core {
namespace {

template <class Visit>
void forEachNeighbor(const VolumeGeometry& grid, std::uint32_t voxel, const Visit& visit)
{
    const Eigen::Vector3i place = grid.voxelAt(voxel);
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

std::vector<std::uint16_t> computeNecksFrom(const std::vector<std::uint32_t>& seeds, const DistanceMap& distances,
                                            TracingProgress& progress)
{
    struct FrontVoxel {
        std::uint16_t neck = 0;
        std::uint32_t voxel = 0;

        bool operator<(const FrontVoxel& wider) const { return neck < wider.neck; }
    };
    std::vector<std::uint16_t> neck(distances.units.size(), 0);
    std::priority_queue<FrontVoxel> front;
    const auto reach = [&](std::uint32_t voxel, std::uint16_t width) {
        if (width > neck[voxel]) {
            neck[voxel] = width;
            front.push({width, voxel});
        }
    };
    for (const std::uint32_t seed : seeds) {
        reach(seed, distances.units[seed]);
    }
    for (std::uint32_t iteration = 0; !front.empty(); ++iteration) {
        const FrontVoxel frontVoxel = front.top();
        front.pop();
        if ((iteration & 0xFFFU) == 0 && !progress.advance(0.0)) {
            break;
        }
        if (frontVoxel.neck == neck[frontVoxel.voxel]) {
            forEachNeighbor(distances.geometry, frontVoxel.voxel,
                            [&](std::uint32_t next) { reach(next, std::min(frontVoxel.neck, distances.units[next])); });
        }
    }
    return neck;
}

}   // namespace

std::vector<std::uint32_t> pathToCenter(std::uint32_t voxel, const DistanceMap& distances)
{
    for (std::vector<std::uint32_t> path{voxel};;) {
        std::uint32_t best = path.back();
        forEachNeighbor(distances.geometry, path.back(), [&](std::uint32_t next) {
            if (distances.units[next] > distances.units[best]) {
                best = next;
            }
        });
        if (best == path.back()) {
            return path;
        }
        path.push_back(best);
    }
}

Necks computeNecks(const VoxelMask& mask, const DistanceMap& distances,
                   const std::vector<Eigen::Vector3d>& seedsInPatient, TracingProgress& progress)
{
    std::vector<std::uint32_t> seeds;
    Necks necks;
    for (const Eigen::Vector3d& seed : seedsInPatient) {
        if (const auto voxel = findVoxelNear(mask, seed)) {
            seeds.push_back(pathToCenter(*voxel, distances).back());
            necks.seedRadiusMm = std::max(necks.seedRadiusMm, distances.mm(seeds.back()));
        }
    }
    necks.units = computeNecksFrom(seeds, distances, progress);
    return necks;
}

double neckMm(const DistanceMap& distances, const Eigen::Vector3i& from, const Eigen::Vector3i& to, double aroundMm)
{
    const VolumeGeometry& grid = distances.geometry;
    const Eigen::Array3i around = (aroundMm / grid.spacingMm.array()).ceil().cast<int>();
    const Eigen::Array3i low = (from.cwiseMin(to).array() - around).max(0);
    const Eigen::Array3i high = (from.cwiseMax(to).array() + around + 1).min(grid.size.array());
    DistanceMap part{{}, distances.unitMm, {}};
    part.geometry.size = high - low;
    part.units.reserve(part.geometry.voxelCount());
    for (int k = low.z(); k < high.z(); ++k) {
        for (int j = low.y(); j < high.y(); ++j) {
            for (int i = low.x(); i < high.x(); ++i) {
                part.units.push_back(distances.units[grid.index(i, j, k)]);
            }
        }
    }
    const auto within = [&](const Eigen::Vector3i& voxel) {
        const Eigen::Vector3i at = voxel.array() - low;
        return static_cast<std::uint32_t>(part.geometry.index(at.x(), at.y(), at.z()));
    };
    TracingProgress noProgress({});
    return part.unitMm * computeNecksFrom({within(from)}, part, noProgress)[within(to)];
}

}   // namespace angiopose::core
