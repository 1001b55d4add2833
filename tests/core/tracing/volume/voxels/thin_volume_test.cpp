#include "core/tracing/volume/voxels/thin_volume.h"
#include "tests/support/drawn_tubes.h"
#include "tests/support/for_each.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

using namespace angiopose;

namespace {

std::vector<std::uint8_t> unpacked(const std::string& relative)
{
    const std::string command = "gzip -dc '" + test::dataFile(relative).string() + "'";
    std::vector<std::uint8_t> bytes;
    if (FILE* pipe = popen(command.c_str(), "r")) {
        std::array<std::uint8_t, 65536> block{};
        while (const std::size_t count = fread(block.data(), 1, block.size(), pipe)) {
            bytes.insert(bytes.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(count));
        }
        pclose(pipe);
    }
    return bytes;
}

std::vector<std::size_t> thin(const core::VoxelMask& mask)
{
    core::TracingProgress progress({});
    return core::skeletonize(mask, progress);
}

core::VoxelMask cube(int size, std::uint8_t fill = 0)
{
    core::VolumeGeometry grid;
    grid.size = Eigen::Vector3i::Constant(size);
    return core::VoxelMask(grid, fill);
}

class LeeReference : public testing::TestWithParam<const char*> {};

TEST_P(LeeReference, AgreesVoxelByVoxel)
{
    const std::string name = std::string("thinning-reference/") + GetParam();
    ANGIOPOSE_NEEDS_DATA(name + "_256_u8.raw.gz");
    core::VoxelMask mask = cube(256);
    mask.voxels = unpacked(name + "_256_u8.raw.gz");
    const std::vector<std::uint8_t> expected = unpacked(name + "_skeleton_lee_256_u8.raw.gz");
    ASSERT_EQ(mask.voxels.size(), mask.geometry.voxelCount());
    ASSERT_EQ(expected.size(), mask.voxels.size());
    std::vector<std::size_t> skeleton;
    for (std::size_t v = 0; v < expected.size(); ++v) {
        if (expected[v] != 0) {
            skeleton.push_back(v);
        }
    }
    EXPECT_EQ(thin(mask), skeleton);
}

INSTANTIATE_TEST_SUITE_P(ThinVolume, LeeReference, testing::Values("vessel_mask", "vessel_mask_thick"));

TEST(ThinVolume, LeavesALineAsItIs)
{
    core::VoxelMask mask = cube(12);
    std::vector<std::size_t> line;
    for (int i = 0; i < 12; ++i) {   // from border to border
        mask.at(i, 5, i) = 1;
        line.push_back(mask.geometry.index(i, 5, i));
    }
    EXPECT_EQ(thin(mask), line);
}

TEST(ThinVolume, ReducesABallToOneVoxelAndKeepsAHollowOneClosed)
{
    core::VoxelMask ball = cube(15);
    test::forEachVoxel({15, 15, 15}, [&](int i, int j, int k) {
        ball.at(i, j, k) = (Eigen::Vector3d(i, j, k) - Eigen::Vector3d::Constant(7)).norm() < 6.0 ? 1 : 0;
    });
    EXPECT_LE(thin(ball).size(), 3U);
    ball.at(7, 7, 7) = 0;
    EXPECT_GE(thin(ball).size(), 18U);   // a cavity keeps a closed shell
}

TEST(ThinVolume, KeepsARingOneVoxelThin)
{
    core::VoxelMask mask = cube(21);
    test::forEachVoxel({0, 0, 8}, {21, 21, 13}, [&](int i, int j, int k) {
        const double radius = Eigen::Vector2d(i - 10, j - 10).norm();
        mask.at(i, j, k) = radius > 5.0 && radius < 9.0 ? 1 : 0;
    });
    const std::vector<std::size_t> ring = thin(mask);
    EXPECT_GT(ring.size(), 24U);
    EXPECT_LT(ring.size(), 50U);
}

TEST(ThinVolume, KeepsTheLengthOfBandsOfAnyWidth)
{
    for (int width = 1; width <= 4; ++width) {
        for (int height = 1; height <= 4; ++height) {
            core::VoxelMask mask = cube(40);
            test::forEachVoxel({10, 10, 2}, {10 + width, 10 + height, 38},
                               [&](int i, int j, int k) { mask.at(i, j, k) = 1; });
            EXPECT_GE(thin(mask).size(), 20U) << width << " x " << height;
        }
    }
}

TEST(ThinVolume, AnswersNothingForNothing)
{
    EXPECT_TRUE(thin(cube(5)).empty());
    EXPECT_TRUE(thin(core::VoxelMask{}).empty());
    EXPECT_EQ(thin(cube(1, 1)).size(), 1U);
}

}   // namespace
