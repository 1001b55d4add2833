#include "core/tracing/volume/great_vessels/great_vessels.h"

#include "tests/support/drawn_tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace angiopose;

namespace {

using test::Tube;

/// Opacified tubes in a body of 120 x 120 x 180 mm.
core::BlockOpacification drawnBlood(const std::vector<Tube>& tubes, const Eigen::Vector3d& voxelMm = {1.5, 1.5, 1.5})
{
    const Eigen::Vector3i size = Eigen::Vector3d(120, 120, 180).cwiseQuotient(voxelMm).array().round().cast<int>();
    const core::VoxelMask lumen = test::drawnMask(test::gridAround({0, 0, 0}, size, voxelMm), tubes);
    core::TracingProgress progress({});
    return core::averageInBlocks(
        lumen, [&](int i, int j, int k) { return lumen.at(i, j, k) != 0 ? 1.0 : 0.0; }, 1, progress);
}

std::vector<core::GreatVessel> foundIn(const core::BlockOpacification& blood)
{
    core::TracingProgress progress({});
    return core::assembleGreatVessels(blood, 1, progress);
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
    const auto found = foundIn(drawnBlood({pulmonaryArtery, leftVentricle, aorta}));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_TRUE(passes(found[0], {-30, 20, 0}, 5.0));
    EXPECT_TRUE(passes(found[1], {20, -25, 40}, 6.0));
    EXPECT_NEAR(found[0].trunks.front().medianRadiusMm(), 9.0, 1.0);
}

TEST(GreatVessels, ChambersAreNone)
{
    EXPECT_TRUE(foundIn(drawnBlood({leftVentricle, {{25, -20, 0}, {30, -22, 6}, 20.0}})).empty());
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
    const auto found = foundIn(drawnBlood(tubes));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(passes(found[0], {-28, 0, -60}, 6.0));
    EXPECT_TRUE(passes(found[0], {28, 0, -40}, 6.0));
    EXPECT_TRUE(passes(found[0], {0, 0, 48}, 8.0));
}

TEST(GreatVessels, VesselsThatTouchAreTwo)
{
    const auto found =
        foundIn(drawnBlood({aorta, {{-9, 20, -60}, {-9, 20, 60}, 9.0}, {{-30, 20, 0}, {-9, 20, 0}, 2.0}}));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_FALSE(passes(found[0], {-9, 20, 40}, 6.0));
}

TEST(GreatVessels, AreTheSameInVoxelsOfAnySize)
{
    const auto usual = foundIn(drawnBlood({pulmonaryArtery, leftVentricle, aorta}));
    ASSERT_EQ(usual.size(), 2U);
    for (const Eigen::Vector3d& voxelMm : {Eigen::Vector3d(0.6, 0.6, 0.6), Eigen::Vector3d(1.0, 1.0, 1.0),
                                           Eigen::Vector3d(1.2, 1.2, 1.2), Eigen::Vector3d(0.75, 0.75, 5.0)}) {
        const core::BlockOpacification blood = drawnBlood({pulmonaryArtery, leftVentricle, aorta}, voxelMm);
        EXPECT_TRUE((blood.lumen.geometry.spacingMm.array() == 1.5).all());
        const auto found = foundIn(blood);
        ASSERT_EQ(found.size(), 2U) << voxelMm.transpose();
        EXPECT_NEAR(found[0].score() / usual[0].score(), 1.0, 0.1) << voxelMm.transpose();
        for (std::size_t n = 0; n < 2; ++n) {
            EXPECT_LT((found[n].centerInPatient() - usual[n].centerInPatient()).norm(), 6.0) << voxelMm.transpose();
        }
    }
}

TEST(GreatVessels, AreWalkedWhereTheyAreFlattened)
{
    std::vector<Tube> tubes{{{-30, 20, 30}, {-30, 20, 85}, 9.0}, {{-30, 20, -85}, {-30, 20, -30}, 7.0}};
    for (double x = -39.0; x <= -21.0; x += 3.0) {   // true lumen of a dissected aorta: 27 mm wide, 9 mm thick
        tubes.push_back({{x, 20, -30}, {x, 20, 30}, 4.5});
    }
    const auto found = foundIn(drawnBlood(tubes));
    ASSERT_FALSE(found.empty());
    const core::Trunk& first = found.front().trunks.front();
    EXPECT_LT(first.pointsInPatient.front().z() * first.pointsInPatient.back().z(), 0.0);
    EXPECT_GT(std::abs(first.pointsInPatient.front().z() - first.pointsInPatient.back().z()), 140.0);
}

TEST(GreatVessels, DoNotHoldVesselsOfOtherBlood)
{
    const auto along = [](double fill) {
        const core::VolumeGeometry grid = test::gridAround({0, 0, 0}, {40, 40, 120}, {1.5, 1.5, 1.5});
        const core::VoxelMask lumen = test::drawnMask(grid, {{{0, 0, -85}, {0, 0, 85}, 8.0}});
        const core::VoxelMask neck = test::drawnMask(grid, {{{0, 0, -3}, {0, 0, 3}, 8.0}});
        const core::VoxelMask open = test::drawnMask(grid, {{{0, 0, -30}, {0, 0, 30}, 5.0}});
        core::TracingProgress progress({});
        const auto blood = [&](int i, int j, int k) {
            const bool isWall = neck.at(i, j, k) != 0 && open.at(i, j, k) == 0;
            return lumen.at(i, j, k) == 0 || isWall ? 0.0 : 2 * k < grid.size.z() ? fill : 1.0;
        };
        return foundIn(core::averageInBlocks(lumen, blood, 1, progress));
    };
    const auto same = along(0.95);
    const auto other = along(0.65);
    ASSERT_FALSE(same.empty() || other.empty());
    EXPECT_TRUE(passes(same[0], {0, 0, -50}, 5.0));
    EXPECT_TRUE(passes(other[0], {0, 0, 50}, 5.0));
    EXPECT_FALSE(passes(other[0], {0, 0, -50}, 5.0));
}

/// An aortic arch whose true lumen is compressed by the flap to a thickness of 9 mm, and to a radius of `narrowMm` at
/// one point.
core::BlockOpacification tornArch(double narrowMm, double descendingFill)
{
    std::vector<Tube> tubes{{{30, 0, -70}, {30, 0, 38}, 13.0}};
    for (double y = -9.0; y <= 9.0; y += 3.0) {
        tubes.push_back({{-30, y, -85}, {-30, y, 35}, 4.5});
        tubes.push_back({{-30, y, 35}, {-4, y, 35}, 4.5});
    }
    tubes.push_back({{-4, 0, 35}, {30, 0, 35}, narrowMm});
    const core::VoxelMask lumen = test::drawnMask(test::gridAround({0, 0, 0}, {80, 40, 120}, {1.5, 1.5, 1.5}), tubes);
    core::TracingProgress progress({});
    const auto fill = [&](int i, int j, int k) {
        return lumen.at(i, j, k) == 0 ? 0.0 : 2 * i < lumen.geometry.size.x() ? descendingFill : 1.0;
    };
    return core::averageInBlocks(lumen, fill, 1, progress);
}

TEST(GreatVessels, GoOnThroughNarrowPlacesOfTheSameBlood)
{
    const auto holdsBoth = [](const std::vector<core::GreatVessel>& found) {
        return !found.empty() && passes(found[0], {30, 0, -20}, 5.0) && passes(found[0], {-30, 0, -40}, 5.0);
    };
    EXPECT_TRUE(holdsBoth(foundIn(tornArch(3.2, 0.97))));
    EXPECT_FALSE(holdsBoth(foundIn(tornArch(3.2, 0.83))));   // a vein running next to it
    EXPECT_FALSE(holdsBoth(foundIn(tornArch(1.2, 0.97))));
}

TEST(GreatVessels, AreNamedByAPlaceInThem)
{
    const auto found = foundIn(drawnBlood({aorta}));
    ASSERT_EQ(found.size(), 1U);
    const Eigen::Vector3d middle = found[0].centerInPatient();
    EXPECT_LT((middle.head<2>() - Eigen::Vector2d(-30, 20)).norm(), 2.0);
    EXPECT_LT(std::abs(middle.z()), 60.0);
    EXPECT_TRUE(foundIn(drawnBlood({})).empty());
}

}   // namespace
