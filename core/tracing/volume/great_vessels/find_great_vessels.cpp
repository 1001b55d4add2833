#include "core/tracing/volume/great_vessels/find_great_vessels.h"

#include <utility>

namespace angiopose::core {
namespace {

double firstScore(const std::vector<GreatVessel>& great)
{
    return great.empty() ? 0.0 : great.front().score();
}

}   // namespace

LumenWithGreatVessels findGreatVessels(SegmentedLumen segmented, const VoxelOpacification& opacification, int threads,
                                       TracingProgress& progress, double blockMm)
{
    const auto findIn = [&](const VoxelMask& lumen) {
        return assembleGreatVessels(averageInBlocks(lumen, opacification, threads, progress, blockMm), threads,
                                    progress);
    };
    LumenWithGreatVessels found{std::move(segmented.clear), {}};
    found.great = findIn(found.lumen);
    if (segmented.besideStruts.empty() || !progress.advance(0.0)) {
        return found;
    }
    for (const std::uint32_t voxel : segmented.besideStruts) {
        found.lumen.voxels[voxel] = 1;
    }
    std::vector<GreatVessel> others = findIn(found.lumen);
    if (firstScore(others) > firstScore(found.great)) {
        found.great = std::move(others);
    }
    return found;
}

}   // namespace angiopose::core
