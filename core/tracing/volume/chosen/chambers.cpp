#include "core/tracing/volume/chosen/chambers.h"

namespace angiopose::core {
namespace {

constexpr double minSeedRadiusMm = 5.0;   ///< thinner vessels do not indicate the width of their trunk
constexpr double minChamberRadiusMm = 4.0;   ///< thinner leaks are left to pruning
constexpr double minNeckShare = 0.3;   ///< relative to the radius beyond; stenoses and compressed lumens exceed this
constexpr double minWideNeckShare = 0.5;   ///< for regions wider than the seeds' vessel; an open valve is narrower
constexpr double maxChamberShare = 1.35;   ///< maximum radius relative to the radius at the seed

}   // namespace

std::vector<std::uint32_t> voxelsBeyondNecks(const DistanceMap& distances, const Necks& necks)
{
    std::vector<std::uint32_t> beyond;
    if (necks.seedRadiusMm < minSeedRadiusMm) {
        return beyond;
    }
    for (std::uint32_t voxel = 0; voxel < necks.units.size(); ++voxel) {
        const double radiusMm = distances.mm(voxel);
        const bool isWide = radiusMm > maxChamberShare * necks.seedRadiusMm;
        const double minNeck = (isWide ? minWideNeckShare : minNeckShare) * distances.units[voxel];
        if (radiusMm >= minChamberRadiusMm && necks.units[voxel] > 0 && necks.units[voxel] < minNeck) {
            beyond.push_back(voxel);
        }
    }
    return beyond;
}

}   // namespace angiopose::core
