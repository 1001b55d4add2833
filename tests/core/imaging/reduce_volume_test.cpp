#include "core/imaging/reduce_volume.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

/// A volume whose voxel values encode the voxel positions.
Volume numbered(const Eigen::Vector3i& size, const Eigen::Vector3d& spacingMm)
{
    VolumeGeometry geometry;
    geometry.size = size;
    geometry.spacingMm = spacingMm;
    geometry.originInPatient = {10, 20, 30};
    Volume volume(geometry);
    for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
        const Eigen::Vector3i at = geometry.voxelAt(i);
        volume.voxels[i] = static_cast<std::int16_t>(at.x() + 100 * at.y() + 1000 * at.z());
    }
    return volume;
}

bool always()
{
    return true;
}

TEST(ReduceVolume, TakesTheMeanOfBlocksAndKeepsTheirPlace)
{
    const Volume volume = numbered({8, 8, 4}, {1, 1, 2});
    const auto half = downsample(volume, voxelRangeIn(volume.geometry, {}), 4 * 4 * 4, always);
    ASSERT_TRUE(half);
    EXPECT_EQ(half->geometry.size, Eigen::Vector3i(4, 4, 4));   // the slice spacing already has that size
    EXPECT_EQ(half->geometry.spacingMm, Eigen::Vector3d(2, 2, 2));
    EXPECT_EQ(half->geometry.originInPatient, Eigen::Vector3d(10.5, 20.5, 30));
    EXPECT_NEAR(half->at(1, 2, 3), 2.5 + 450 + 3000, 0.5);
}

TEST(ReduceVolume, TakesTheMeanOfBlocksThatAreAskedFor)
{
    const Volume volume = numbered({7, 8, 4}, {1, 1, 2});
    const auto blocks = averageBlocks(volume, {{1, 0, 0}, {7, 8, 3}}, {2, 4, 1}, always);
    ASSERT_TRUE(blocks);
    EXPECT_EQ(blocks->geometry.size, Eigen::Vector3i(3, 2, 3));
    EXPECT_EQ(blocks->geometry.originInPatient, volume.geometry.originInPatient + Eigen::Vector3d(1.5, 1.5, 0.0));
    EXPECT_NEAR(blocks->at(0, 0, 1), 0.5 * (volume.at(1, 1, 1) + volume.at(2, 2, 1)), 0.5);
}

TEST(ReduceVolume, LeavesFewEnoughVoxelsWhateverTheShape)
{
    const Volume volume = numbered({37, 22, 9}, {0.7, 0.7, 3.0});
    for (const std::size_t most : {7000U, 900U, 30U, 1U}) {
        const auto few = downsample(volume, voxelRangeIn(volume.geometry, {}), most, always);
        ASSERT_TRUE(few);
        EXPECT_LE(few->voxels.size(), most);
        const Eigen::Vector3d reach = few->geometry.spacingMm.cwiseProduct(few->geometry.size.cast<double>());
        EXPECT_TRUE((reach.array() >= Eigen::Array3d(37 * 0.7, 22 * 0.7, 27.0) - 1e-9).all());
    }
}

TEST(ReduceVolume, CutsOutABoxOfThePatient)
{
    const Volume volume = numbered({8, 8, 8}, {1, 1, 1});
    const VoxelRange range =
        voxelRangeIn(volume.geometry, Eigen::AlignedBox3d(Eigen::Vector3d(12, 0, 32.2), Eigen::Vector3d(14, 21, 33)));
    EXPECT_EQ(range.low, Eigen::Vector3i(2, 0, 2));
    EXPECT_EQ(range.high, Eigen::Vector3i(5, 2, 4));
    const auto part = downsample(volume, range, 1000, always);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->at(0, 1, 1), 2 + 100 + 3000);
    EXPECT_EQ(part->geometry.originInPatient, Eigen::Vector3d(12, 20, 32));
    const VoxelRange beside =
        voxelRangeIn(volume.geometry, Eigen::AlignedBox3d(Eigen::Vector3d(90, 0, 0), Eigen::Vector3d(99, 50, 50)));
    EXPECT_FALSE(downsample(volume, beside, 1000, always));
    EXPECT_FALSE(downsample(volume, range, 1000, [] { return false; }));
}

}   // namespace
}   // namespace angiopose::core
