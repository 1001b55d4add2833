#include "core/tracing/volume/chosen/fill_cavities.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

/// 12 × 12 × 12 voxels, all set except for a sheet at i = 6 and a hole at (3, 3, 3).
core::VoxelMask blockWithSheetAndHole()
{
    core::VolumeGeometry geometry;
    geometry.size = {12, 12, 12};
    core::VoxelMask mask(geometry);
    test::forEachVoxel({12, 12, 12}, [&](int i, int j, int k) { mask.at(i, j, k) = i == 6 ? 0 : 1; });
    mask.at(3, 3, 3) = 0;
    return mask;
}

TEST(FillHoles, FillsWhatNoiseTookOut)
{
    core::VoxelMask mask = blockWithSheetAndHole();
    core::fillHoles(mask);
    EXPECT_EQ(mask.at(3, 3, 3), 2);
}

TEST(FillHoles, LeavesDarkWalls)
{
    core::VoxelMask mask = blockWithSheetAndHole();
    core::fillHoles(mask, [](int i, int, int) { return i < 5; });
    EXPECT_EQ(mask.at(3, 3, 3), 2);
    for (int k = 0; k < 12; ++k) {
        for (int j = 0; j < 12; ++j) {
            EXPECT_EQ(mask.at(6, j, k), 0);
        }
    }
}

TEST(FillCavities, FillsOnlyWhatIsEnclosed)
{
    core::VoxelMask mask = blockWithSheetAndHole();
    core::fillCavities(mask);
    EXPECT_EQ(mask.at(3, 3, 3), 2);
    EXPECT_EQ(mask.at(6, 5, 5), 0);   // open at the border
    EXPECT_EQ(mask.at(1, 1, 1), 1);
}

}   // namespace
