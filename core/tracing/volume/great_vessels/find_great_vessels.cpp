#include "core/tracing/volume/great_vessels/find_great_vessels.h"

#include <utility>

namespace angiopose::core {
namespace {

double worthOfFirst(const std::vector<GreatVessel>& great)
{
    return great.empty() ? 0.0 : great.front().worth();
}

}   // namespace

LumenWithGreatVessels findGreatVessels(SegmentedLumen segmented, const VoxelFill& fill, int threads,
                                       TracingProgress& progress, double blockMm)
{
    const auto greatIn = [&](const VoxelMask& lumen) {
        return greatVessels(coarseBlood(lumen, fill, threads, progress, blockMm), threads, progress);
    };
    LumenWithGreatVessels found{std::move(segmented.clear), {}};
    found.great = greatIn(found.lumen);
    if (segmented.besideWires.empty() || !progress.advance(0.0)) {
        return found;
    }
    for (const std::uint32_t voxel : segmented.besideWires) {
        found.lumen.voxels[voxel] = 1;
    }
    std::vector<GreatVessel> others = greatIn(found.lumen);
    if (worthOfFirst(others) > worthOfFirst(found.great)) {
        found.great = std::move(others);
    }
    return found;
}

}   // namespace angiopose::core
