#include "core/tracing/volume/great_vessels.h"

#include "tests/support/drawn_tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using test::Tube;

/// Tubes filled to `fill` in a body of 120 x 120 x 180 mm.
core::CoarseBlood drawn(const std::vector<Tube>& tubes, double fill = 1.0)
{
    const core::VolumeGeometry grid = test::gridAround({0, 0, 0}, {80, 80, 120}, {1.5, 1.5, 1.5});
    const core::VoxelMask lumen = test::drawnMask(grid, tubes);
    core::TracingProgress progress({});
    return core::coarseBlood(
        lumen, [&](int i, int j, int k) { return lumen.at(i, j, k) != 0 ? fill : 0.0; }, 1, progress);
}

std::vector<core::GreatVessel> foundIn(const core::CoarseBlood& blood)
{
    core::TracingProgress progress({});
    return core::greatVessels(blood, 1, progress);
}

bool passes(const core::GreatVessel& vessel, const Eigen::Vector3d& place, double withinMm)
{
    return std::any_of(vessel.trunks.begin(), vessel.trunks.end(), [&](const core::Trunk& trunk) {
        return std::any_of(trunk.pointsInPatient.begin(), trunk.pointsInPatient.end(),
                           [&](const auto& point) { return (point - place).norm() <= withinMm; });
    });
}

const Tube aorta{{-30, 20, -85}, {-30, 20, 85}, 9.0};
const Tube pulmonaryArtery{{-15, -25, 40}, {55, -25, 40}, 11.0};
const Tube leftVentricle{{20, 20, -30}, {30, 20, -45}, 24.0};

TEST(GreatVessels, TheLongOneAlongTheBodyComesFirst)
{
    const auto found = foundIn(drawn({pulmonaryArtery, leftVentricle, aorta}));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_TRUE(passes(found[0], {-30, 20, 0}, 5.0));
    EXPECT_TRUE(passes(found[1], {20, -25, 40}, 6.0));
    EXPECT_NEAR(found[0].trunks.front().medianRadiusMm(), 9.0, 1.0);
}

TEST(GreatVessels, ChambersAreNone)
{
    EXPECT_TRUE(foundIn(drawn({leftVentricle, {{25, -20, 0}, {30, -22, 6}, 20.0}})).empty());
}

TEST(GreatVessels, WalksRoundAnArch)
{
    std::vector<Tube> tubes{{{-28, 0, -80}, {-28, 0, 20}, 9.0}, {{28, 0, 20}, {28, 0, -60}, 11.0}};
    const auto onArch = [](int n) {
        const double angle = std::numbers::pi * n / 12.0;
        return Eigen::Vector3d(-28.0 * std::cos(angle), 0, 20.0 + 28.0 * std::sin(angle));
    };
    for (int n = 0; n < 12; ++n) {
        tubes.push_back({onArch(n), onArch(n + 1), 10.0});
    }
    const auto found = foundIn(drawn(tubes));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(passes(found[0], {-28, 0, -60}, 6.0));
    EXPECT_TRUE(passes(found[0], {28, 0, -40}, 6.0));
    EXPECT_TRUE(passes(found[0], {0, 0, 48}, 8.0));
}

TEST(GreatVessels, VesselsThatTouchAreTwo)
{
    const auto found = foundIn(drawn({aorta, {{-9, 20, -60}, {-9, 20, 60}, 9.0}, {{-30, 20, 0}, {-9, 20, 0}, 2.0}}));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_FALSE(passes(found[0], {-9, 20, 40}, 6.0));
}

TEST(GreatVessels, AreNamedByAPlaceInThem)
{
    const auto found = foundIn(drawn({aorta}));
    ASSERT_EQ(found.size(), 1U);
    const Eigen::Vector3d middle = found[0].middleInPatient();
    EXPECT_LT((middle.head<2>() - Eigen::Vector2d(-30, 20)).norm(), 2.0);
    EXPECT_LT(std::abs(middle.z()), 60.0);
    EXPECT_TRUE(foundIn(drawn({})).empty());
}

}   // namespace
