#include "core/tracing/volume/stents/wide_basins.h"

#include "tests/support/drawn_tubes.h"

#include <gtest/gtest.h>

#include <set>

using namespace angiopose;

namespace {

/// A box of 60 mm around the origin in 1 mm voxels.
class WideBasins : public testing::Test {
protected:
    explicit WideBasins() : grid_(test::gridAround({0, 0, 0}, {60, 60, 60}, {1.0, 1.0, 1.0})) {}

    void draw(const std::vector<test::Tube>& tubes)
    {
        mask_ = test::drawnMask(grid_, tubes);
        core::TracingProgress progress({});
        basins_ = core::labelWideBasins(core::distanceMap(mask_, 1, progress), 0.45);
    }

    std::uint32_t at(const Eigen::Vector3d& place) const
    {
        const Eigen::Vector3i voxel = (grid_.patientFromVoxel().inverse() * place).array().round().cast<int>();
        return basins_[grid_.index(voxel.x(), voxel.y(), voxel.z())];
    }

    core::VolumeGeometry grid_;
    core::VoxelMask mask_;
    std::vector<std::uint32_t> basins_;
};

TEST_F(WideBasins, VesselsThatTouchAreTwo)
{
    draw({{{-8, 0, -25}, {-8, 0, 25}, 7.0}, {{8, 0, -25}, {8, 0, 25}, 7.0}, {{-8, 0, 0}, {8, 0, 0}, 1.5}});
    EXPECT_NE(at({-8, 0, 0}), at({8, 0, 0}));
    EXPECT_EQ(std::set<std::uint32_t>(basins_.begin(), basins_.end()).size(), 3U);   // including the background
    for (const double z : {-20.0, -3.0, 3.0, 20.0}) {   // including the walls
        EXPECT_EQ(at({-14, 0, z}), at({-8, 0, 0}));
        EXPECT_EQ(at({-3, 0, z}), at({-8, 0, 0}));
        EXPECT_EQ(at({3, 0, z}), at({8, 0, 0}));
    }
}

TEST_F(WideBasins, AVesselThatTapersIsOne)
{
    draw({{{0, 0, -25}, {0, 0, 25}, 9.0, 2.0}, {{0, 0, -10}, {25, 0, 5}, 2.5}});
    EXPECT_EQ(std::set<std::uint32_t>(basins_.begin(), basins_.end()), (std::set<std::uint32_t>{0, at({0, 0, -20})}));
}

TEST_F(WideBasins, OutsideIsNone)
{
    draw({{{0, 0, -25}, {0, 0, 25}, 5.0}});
    for (std::size_t voxel = 0; voxel < basins_.size(); ++voxel) {
        EXPECT_EQ(basins_[voxel] != 0, mask_.voxels[voxel] != 0);
    }
}

}   // namespace
