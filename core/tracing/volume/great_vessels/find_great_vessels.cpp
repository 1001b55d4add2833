#include "core/tracing/volume/great_vessels/find_great_vessels.h"

#include <utility>

namespace angiopose::core {
namespace {

double firstScore(const std::vector<GreatVessel>& greatVessels)
{
    return greatVessels.empty() ? 0.0 : greatVessels.front().score();
}

}   // namespace

LumenWithGreatVessels findGreatVessels(SegmentedLumen segmented, const VoxelOpacification& opacification, int threads,
                                       TracingProgress& progress, double blockMm)
{
    const auto findIn = [&](const VoxelMask& lumen) {
        return assembleGreatVessels(averageInBlocks(lumen, opacification, threads, progress, blockMm), threads,
                                    progress);
    };
    LumenWithGreatVessels found{std::move(segmented.clearLumen), {}};
    found.greatVessels = findIn(found.lumen);
    if (segmented.voxelsBesideStruts.empty() || !progress.advance(0.0)) {
        return found;
    }
    for (const std::uint32_t voxel : segmented.voxelsBesideStruts) {
        found.lumen.voxels[voxel] = 1;
    }
    std::vector<GreatVessel> others = findIn(found.lumen);
    if (firstScore(others) > firstScore(found.greatVessels)) {
        found.greatVessels = std::move(others);
    }
    return found;
}

}   // namespace angiopose::core
