#include "core/imaging/volume.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

TEST(VolumeGeometry, VoxelAtIsTheInverseOfIndex)
{
    VolumeGeometry geometry;
    geometry.size = {5, 4, 3};
    for (std::size_t index = 0; index < geometry.voxelCount(); ++index) {
        const Eigen::Vector3i voxel = geometry.voxelAt(index);
        EXPECT_TRUE(geometry.contains(voxel));
        EXPECT_EQ(geometry.index(voxel.x(), voxel.y(), voxel.z()), index);
    }
}

TEST(VolumeGeometry, CountsBeyond32Bits)
{
    VolumeGeometry geometry;
    geometry.size = {2048, 2048, 2048};
    const Eigen::Vector3i last(2047, 2046, 2047);
    EXPECT_EQ(geometry.voxelAt(geometry.index(last.x(), last.y(), last.z())), last);
}

}   // namespace
}   // namespace angiopose::core
