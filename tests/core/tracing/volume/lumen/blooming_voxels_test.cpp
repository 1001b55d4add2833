#include "core/tracing/volume/lumen/blooming_voxels.h"

#include <gtest/gtest.h>

#include <vector>

using namespace angiopose;

namespace {

constexpr core::BloomingBits bits;

/// A row of voxels; the first one is bright.
class BloomingVoxels : public testing::Test {
protected:
    std::vector<bool> bloomingOf(const std::vector<double>& fills, int reach = 8, std::size_t solidAt = 0)
    {
        core::VolumeGeometry grid;
        grid.size = {static_cast<int>(fills.size()), 1, 1};
        core::VoxelMask flags(grid);
        flags.voxels.front() = bits.bright;
        if (solidAt > 0) {
            flags.voxels[solidAt] = bits.solid;
        }
        core::TracingProgress progress({});
        core::markBlooming(
            flags, bits, [&](int i, int, int) { return fills[static_cast<std::size_t>(i)]; }, 0.25, {reach, 1, 1},
            progress);
        std::vector<bool> isBlooming;
        for (const std::uint8_t flag : flags.voxels) {
            isBlooming.push_back((flag & bits.blooming) != 0);
        }
        return isBlooming;
    }
};

TEST_F(BloomingVoxels, PassTheBrightnessOfBlood)
{
    EXPECT_EQ(bloomingOf({5.0, 1.4, 0.9, 0.6, 0.3, 0.1, 0.0}),
              (std::vector<bool>{false, true, true, true, true, false, false}));
}

TEST_F(BloomingVoxels, EndWhereAVesselBegins)
{
    EXPECT_EQ(bloomingOf({5.0, 1.4, 0.5, 0.9, 0.7, 0.3}), (std::vector<bool>{false, true, true, false, false, false}));
}

TEST_F(BloomingVoxels, ReachOnlySoFar)
{
    EXPECT_EQ(bloomingOf({5.0, 1.4, 1.2, 1.0, 0.8}, 2), (std::vector<bool>{false, true, true, false, false}));
}

TEST_F(BloomingVoxels, LeaveTheInnerOfWideVessels)
{
    EXPECT_EQ(bloomingOf({5.0, 1.4, 1.1, 1.0, 0.8}, 8, 2), (std::vector<bool>{false, true, false, false, false}));
}

}   // namespace
