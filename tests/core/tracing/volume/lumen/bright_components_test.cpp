#include "core/tracing/volume/lumen/bright_components.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace angiopose;

namespace {

/// Beads of 1 mm³ with centers 2 mm apart, in voxels of `voxelMm`, plus one isolated bead.
core::VoxelMask beads(double voxelMm, int count)
{
    core::VolumeGeometry grid;
    grid.spacingMm = Eigen::Vector3d::Constant(voxelMm);
    grid.size = (Eigen::Array3d(60.0, 8.0, 8.0) / voxelMm).round().cast<int>();
    core::VoxelMask mask(grid);
    const int side = static_cast<int>(std::lround(1.0 / voxelMm));
    const auto draw = [&](double atMm) {
        const int first = static_cast<int>(std::lround(atMm / voxelMm));
        for (int n = 0; n < side * side * side; ++n) {
            mask.at(first + n % side, side + n / side % side, side + n / (side * side)) = 1;
        }
    };
    for (int n = 0; n < count; ++n) {
        draw(2.0 + 2.0 * n);
    }
    draw(56.0);
    return mask;
}

TEST(MarkBrightPieces, JoinsWhatLiesCloseWhateverTheVoxels)
{
    for (const double voxelMm : {1.0, 0.5, 0.25}) {
        for (const int count : {4, 20}) {
            core::VoxelMask mask = beads(voxelMm, count);
            const auto bright = std::count(mask.voxels.begin(), mask.voxels.end(), 1);
            const auto beadVoxels = bright / (count + 1);
            core::labelBrightComponents(mask, 0.01, {.large = 8, .small = 16});
            const auto large = std::count(mask.voxels.begin(), mask.voxels.end(), 8);
            const auto small = std::count(mask.voxels.begin(), mask.voxels.end(), 16);
            EXPECT_EQ(large + small, bright) << voxelMm;
            EXPECT_EQ(large, count == 20 ? 20 * beadVoxels : 0) << voxelMm;
        }
    }
}

}   // namespace
