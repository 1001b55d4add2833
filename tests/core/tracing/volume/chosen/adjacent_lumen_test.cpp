#include "core/tracing/volume/chosen/adjacent_lumen.h"
#include "core/messages/messages.h"

#include "core/tracing/volume/trace_vessels.h"
#include "core/tracing/volume/tracing_warnings.h"
#include "tests/support/drawn_tubes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace angiopose;

namespace {

using test::Tube;

core::GreatVessel vesselAlong(const Tube& tube)
{
    core::Trunk trunk;
    for (int n = 0; n <= 40; ++n) {
        trunk.pointsInPatient.emplace_back(tube.fromMm + n / 40.0 * (tube.toMm - tube.fromMm));
        trunk.radiusMm.push_back(tube.radiusMm);
    }
    return {{trunk}};
}

/// Result for a traced vessel with other vessels running parallel to it.
double adjacentMm(const Tube& traced, const std::vector<Tube>& others)
{
    const core::VolumeGeometry grid = test::gridAround({0, 0, 0}, {80, 80, 200}, {1.0, 1.0, 1.0});
    std::vector<core::GreatVessel> greatVessels{vesselAlong(traced)};
    for (const Tube& other : others) {
        greatVessels.push_back(vesselAlong(other));
    }
    return core::possibleFalseLumen(test::drawnMask(grid, {traced}), greatVessels).adjacentMm;
}

const Tube trueLumen{{0, 0, -90}, {0, 0, 90}, 6.0};
const Tube falseLumen{{16, 0, -50}, {16, 0, 70}, 8.0};   // 2 mm between the lumina

TEST(AdjacentLumen, RunsAlongTheTracedOne)
{
    EXPECT_NEAR(adjacentMm(trueLumen, {falseLumen}), 120.0, 10.0);
    EXPECT_NEAR(adjacentMm(falseLumen, {trueLumen}), 120.0, 25.0);
}

TEST(AdjacentLumen, IsNoVesselThatCrossesOrKeepsAway)
{
    const Tube crossing{{-38, 16, 0}, {38, 16, 10}, 9.0};
    const Tube away{{24, 0, -90}, {24, 0, 90}, 8.0};
    EXPECT_EQ(adjacentMm(trueLumen, {crossing}), 0.0);
    EXPECT_EQ(adjacentMm(trueLumen, {away}), 0.0);
}

TEST(AdjacentLumen, IsNotTheTracedOneItself)
{
    EXPECT_EQ(adjacentMm(trueLumen, {trueLumen}), 0.0);
}

bool warnsOfOtherLumen(const std::vector<Tube>& tubes, const std::vector<Eigen::Vector3d>& seeds = {})
{
    const core::VolumeGeometry grid = test::gridAround({0, 0, 0}, {70, 60, 200}, {1.0, 1.0, 1.0});
    const auto traced = core::traceVessels(test::tubesInTissue(grid, tubes), {.seedsInPatient = seeds});
    EXPECT_TRUE(traced) << traced.error().message;
    return traced && std::ranges::any_of(traced.value().warnings, [](const core::Message& warning) {
               return warning.is(core::messages::possibleFalseLumen);
           });
}

TEST(AdjacentLumen, IsWarnedAboutUnlessItIsTracedToo)
{
    const Tube one{{-10, 0, -90}, {-10, 0, 90}, 8.0};
    const Tube other{{8, 0, -90}, {8, 0, 90}, 7.0};
    EXPECT_TRUE(warnsOfOtherLumen({one, other}));
    EXPECT_TRUE(warnsOfOtherLumen({one, other}, {{8, 0, 0}}));
    EXPECT_FALSE(warnsOfOtherLumen({one, other}, {{8, 0, 0}, {-10, 0, 0}}));
    EXPECT_FALSE(warnsOfOtherLumen({one}));
}

TEST(AdjacentLumen, IsToldWithAPlaceInIt)
{
    const Tube one{{-10, 0, -90}, {-10, 0, 90}, 8.0};
    const Tube other{{8, 0, -90}, {8, 0, 90}, 7.0};
    const core::VolumeGeometry grid = test::gridAround({0, 0, 0}, {70, 60, 200}, {1.0, 1.0, 1.0});
    const auto traced = core::traceVessels(test::tubesInTissue(grid, {one, other}), {.seedsInPatient = {{-10, 0, 0}}});
    ASSERT_TRUE(traced);
    const auto place = core::adjacentLumenPosition(traced.value().warnings);
    ASSERT_TRUE(place);
    EXPECT_LT((place->head<2>() - Eigen::Vector2d(8, 0)).norm(), 4.0) << *place;
    EXPECT_LT(std::abs(place->z()), 60.0);
    EXPECT_FALSE(core::adjacentLumenPosition({}));
}

}   // namespace
