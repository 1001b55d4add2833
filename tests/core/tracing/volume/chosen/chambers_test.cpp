#include "core/tracing/volume/chosen/chambers.h"

#include "core/tracing/volume/chosen/split_by_seeds.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using core::VoxelMask;

/// A volume of 80 × 60 × 60 mm with a straight vessel of 8 mm radius along x.
class Chambers : public testing::Test {
protected:
    Chambers() : mask_(grid()) { addTube({0, 30, 30}, {79, 30, 30}, 8.0); }

    static core::VolumeGeometry grid()
    {
        core::VolumeGeometry geometry;
        geometry.size = {80, 90, 60};
        geometry.spacingMm = {1.0, 1.0, 1.0};
        return geometry;
    }

    void addTube(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radiusMm)
    {
        const Eigen::Vector3d way = to - from;
        test::forEachVoxel({80, 90, 60}, [&](int i, int j, int k) {
            const Eigen::Vector3d offset = Eigen::Vector3d(i, j, k) - from;
            const double share = way.norm() > 0.0 ? std::clamp(offset.dot(way) / way.squaredNorm(), 0.0, 1.0) : 0.0;
            if ((offset - share * way).norm() <= radiusMm) {
                mask_.at(i, j, k) = 1;
            }
        });
    }

    std::vector<std::uint32_t> beyond(const Eigen::Vector3d& seed)
    {
        core::TracingProgress progress({});
        const core::DistanceMap distances = core::distanceMap(mask_, 1, progress);
        return core::voxelsBeyondNecks(distances, core::computeNecks(mask_, distances, {seed}, progress));
    }

    bool holds(const std::vector<std::uint32_t>& voxels, int i, int j, int k) const
    {
        return std::binary_search(voxels.begin(), voxels.end(),
                                  static_cast<std::uint32_t>(mask_.geometry.index(i, j, k)));
    }

    VoxelMask mask_;
};

TEST_F(Chambers, LeakedVeinsLieBeyondANeck)
{
    addTube({0, 52, 30}, {79, 52, 30}, 8.0);   // a parallel vessel
    addTube({40, 30, 30}, {40, 52, 30}, 1.5);   // connected at one point
    const auto found = beyond({10, 30, 30});
    EXPECT_TRUE(holds(found, 20, 52, 30));
    EXPECT_FALSE(holds(found, 70, 30, 30));
}

TEST_F(Chambers, BranchesStenosesAndAneurysmsAreVessels)
{
    addTube({40, 30, 30}, {40, 80, 30}, 4.5);   // a branch
    EXPECT_TRUE(beyond({10, 30, 30}).empty());
    mask_ = VoxelMask(grid());
    addTube({0, 30, 30}, {30, 30, 30}, 8.0);
    addTube({0, 30, 30}, {79, 30, 30}, 4.5);   // a section of half the width
    addTube({50, 30, 30}, {79, 30, 30}, 9.0);   // and a wider section after it
    EXPECT_TRUE(beyond({10, 30, 30}).empty());
}

TEST_F(Chambers, WhatIsMuchWiderThanTheSeedsVesselIsNone)
{
    addTube({66, 50, 30}, {66, 50, 30}, 20.0);   // a chamber with a wide opening
    const auto found = beyond({10, 30, 30});
    EXPECT_TRUE(holds(found, 66, 50, 30));
    EXPECT_FALSE(holds(found, 20, 30, 30));
    EXPECT_TRUE(beyond({66, 50, 30}).empty());   // unless the chamber itself was clicked
}

TEST_F(Chambers, ThinSeedsDoNotJudgeTheirTrunk)
{
    addTube({40, 30, 30}, {40, 80, 30}, 2.0);
    EXPECT_TRUE(beyond({40, 75, 30}).empty());
    EXPECT_TRUE(beyond({5, 5, 5}).empty());   // outside all vessels
}

TEST_F(Chambers, SplittingCutsAtTheNeck)
{
    addTube({0, 52, 30}, {79, 52, 30}, 8.0);
    addTube({40, 30, 30}, {40, 52, 30}, 1.5);
    core::TracingProgress progress({});
    core::splitBySeeds(mask_, {.seedsInPatient = {{10, 30, 30}}}, {}, {}, progress);
    EXPECT_EQ(mask_.at(20, 52, 30), 0);
    EXPECT_EQ(mask_.at(70, 30, 30), 1);
    EXPECT_EQ(mask_.at(70, 30, 37), 1);
}

}   // namespace
