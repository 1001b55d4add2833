#include "core/tracing/volume/voxels/distance_map.h"
#include "core/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace angiopose;

namespace {

TEST(DistanceMap, AgreesWithLookingEverywhere)
{
    core::VolumeGeometry grid;
    grid.size = {13, 11, 9};
    grid.spacingMm = {0.7, 1.1, 2.0};
    core::VoxelMask mask(grid, 1);
    core::CounterRandom random(4);
    for (int n = 0; n < 9; ++n) {
        mask.voxels[static_cast<std::size_t>(random.index(static_cast<int>(mask.voxels.size())))] = 0;
    }
    core::TracingProgress progress({});
    const core::DistanceMap map = core::distanceMap(mask, 2, progress);
    const auto pointOf = [&](std::size_t v) {
        const int i = static_cast<int>(v);
        return Eigen::Vector3d(0.7 * (i % 13), 1.1 * (i / 13 % 11), 2.0 * (i / 143));
    };
    for (std::size_t v = 0; v < mask.voxels.size(); ++v) {
        double nearest = 1e9;
        for (std::size_t w = 0; w < mask.voxels.size(); ++w) {
            if (mask.voxels[w] == 0) {
                nearest = std::min(nearest, (pointOf(v) - pointOf(w)).norm());
            }
        }
        ASSERT_NEAR(map.mm(v), nearest, 0.7 / 100.0);
    }
}

TEST(DistanceMap, TakesTheRimForNoWall)
{
    core::VolumeGeometry grid;
    grid.size = {5, 5, 40};
    core::VoxelMask mask(grid, 1);
    for (int k = 0; k < 40; ++k) {
        mask.at(0, 2, k) = 0;
    }
    core::TracingProgress progress({});
    const core::DistanceMap map = core::distanceMap(mask, 1, progress);
    EXPECT_NEAR(map.mm(grid.index(4, 2, 0)), 4.0, 0.01);
    EXPECT_NEAR(map.mm(grid.index(4, 0, 39)), std::sqrt(20.0), 0.01);
}

}   // namespace
