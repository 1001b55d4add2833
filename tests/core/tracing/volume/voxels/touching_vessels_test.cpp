#include "core/tracing/volume/voxels/touching_vessels.h"

#include "core/tracing/volume/chosen/split_by_seeds.h"
#include "core/tracing/volume/great_vessels/necks.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

/// An artery along x and a second vessel of the same shape parallel to it; both are 9 voxels wide, in 60 × 32 × 15 mm.
class TouchingVessels : public testing::Test {
protected:
    TouchingVessels() : mask_(grid())
    {
        addBox({0, 3, 3}, {60, 12, 12});
        addBox({0, 16, 3}, {60, 25, 12});
    }

    static core::VolumeGeometry grid()
    {
        core::VolumeGeometry geometry;
        geometry.size = {60, 32, 15};
        geometry.spacingMm = {1.0, 1.0, 1.0};
        return geometry;
    }

    void addBox(const Eigen::Vector3i& low, const Eigen::Vector3i& high)
    {
        test::forEachVoxel(low, high, [&](int i, int j, int k) { mask_.at(i, j, k) = 1; });
    }

    /// Voxels with blood of another brightness, seen from the artery, for a given enhancement of the second vessel.
    std::vector<std::uint32_t> others(double secondFill) const
    {
        core::TracingProgress progress({});
        const core::DistanceMap distances = core::distanceMap(mask_, 1, progress);
        const core::Necks necks = core::computeNecks(mask_, distances, {{30.0, 7.0, 7.0}}, progress);
        return core::differentlyOpacifiedVoxels(distances, necks.units,
                                                [&](int, int j, int) { return j < 14 ? 0.97 : secondFill; });
    }

    core::VoxelMask mask_;
};

TEST_F(TouchingVessels, AVeinIsToldByItsBlood)
{
    addBox({30, 12, 7}, {31, 16, 8});   // a contact of one voxel
    const auto vein = others(0.75);
    ASSERT_FALSE(vein.empty());
    for (const std::uint32_t voxel : vein) {
        EXPECT_GE(voxel / 60 % 32, 16U);
    }
    EXPECT_FALSE(others(1.25).empty());   // veins through which the contrast agent arrived
}

TEST_F(TouchingVessels, BehindAStenosisTheBloodIsTheSame)
{
    addBox({30, 12, 7}, {31, 16, 8});
    EXPECT_TRUE(others(0.9).empty());
}

TEST_F(TouchingVessels, WideWaysJoinVesselsOfAnyBlood)
{
    addBox({28, 12, 5}, {33, 16, 10});   // an entry tear, five voxels wide
    EXPECT_TRUE(others(0.75).empty());
}

TEST_F(TouchingVessels, SplittingTakesTheVeinAway)
{
    addBox({30, 12, 7}, {31, 16, 8});
    core::TracingProgress progress({});
    core::splitBySeeds(
        mask_, {.seedsInPatient = {{30.0, 7.0, 7.0}}}, [](int, int j, int) { return j < 14 ? 1.0 : 0.7; }, {},
        progress);
    EXPECT_EQ(mask_.at(10, 20, 7), 0);
    EXPECT_EQ(mask_.at(10, 16, 3), 0);
    EXPECT_EQ(mask_.at(10, 11, 3), 1);
}

TEST_F(TouchingVessels, AnAvoidedPlaceNeedNotLieInTheMiddle)
{
    addBox({20, 12, 3}, {40, 16, 12});   // as wide as the vessels themselves
    const core::VesselTracingOptions options{.seedsInPatient = {{50.0, 7.0, 7.0}},
                                             .avoidInPatient = {{5.0, 24.0, 4.0}}};
    core::TracingProgress progress({});
    core::splitBySeeds(mask_, options, {}, {}, progress);
    EXPECT_EQ(mask_.at(5, 20, 7), 0);
    EXPECT_EQ(mask_.at(15, 20, 7), 0);
    EXPECT_EQ(mask_.at(5, 7, 7), 1);
}

}   // namespace
