#include "core/tracing/angiogram/drawing/edit_centerline.h"

#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using core::Centerline2d;
using core::Curve2d;

/// A horizontal curve at y = `y` from x = 0 to 100, with points 1 px apart.
Curve2d level(int id, double y)
{
    Curve2d curve{id, {}, {}};
    for (int x = 0; x <= 100; ++x) {
        curve.pointsPx.emplace_back(x, y);
        curve.radiusPx.push_back(1.0 + 0.01 * x);
    }
    return curve;
}

const Centerline2d two{{level(3, 10.0), level(7, 40.0)}};

TEST(EditCenterline, ErasingTheMiddleLeavesTwoParts)
{
    const Centerline2d rest = core::eraseDisc(two, {50.0, 12.0}, 10.0);
    ASSERT_EQ(rest.curves.size(), 3U);
    EXPECT_EQ(rest.curves[0].id, 3);
    EXPECT_EQ(rest.curves[0].pointsPx.back().x(), 40.0);
    EXPECT_EQ(rest.curves[1].id, 8) << "above every id in use";
    EXPECT_EQ(rest.curves[1].pointsPx.front().x(), 60.0);
    EXPECT_DOUBLE_EQ(rest.curves[1].radiusPx.front(), 1.6) << "radii stay with their points";
    EXPECT_EQ(rest.curves[2].pointsPx.size(), 101U) << "the other curve is out of reach";
}

TEST(EditCenterline, ErasingAllOfACurveRemovesIt)
{
    const Centerline2d rest = core::eraseDisc(two, {50.0, 10.0}, 52.0);
    ASSERT_EQ(rest.curves.size(), 2U) << "both ends of the lower curve are left";
    EXPECT_EQ(rest.curves[0].id, 7);
    EXPECT_TRUE(core::eraseDisc(two, {50.0, 25.0}, 500.0).curves.empty());
}

TEST(EditCenterline, RestrictingKeepsWhatLiesInThePolygon)
{
    const Centerline2d inside = core::cropToPolygon(two, {{20.5, 0.0}, {80.5, 0.0}, {80.5, 20.0}, {20.5, 20.0}});
    ASSERT_EQ(inside.curves.size(), 1U);
    EXPECT_EQ(inside.curves[0].id, 3);
    EXPECT_EQ(inside.curves[0].pointsPx.front().x(), 21.0);
    EXPECT_EQ(inside.curves[0].pointsPx.back().x(), 80.0);
    EXPECT_EQ(core::cropToPolygon(two, {{0.0, 0.0}, {1.0, 1.0}}).pointCount(), two.pointCount());
}

TEST(EditCenterline, TheRestOfARegionIsWhatRestrictingTakes)
{
    const std::vector<Eigen::Vector2d> box{{20.5, 0.0}, {80.5, 0.0}, {80.5, 20.0}, {20.5, 20.0}};
    const Centerline2d outside = core::erasePolygon(two, box);
    EXPECT_EQ(outside.curves.size(), 3U);
    EXPECT_EQ(outside.pointCount() + core::cropToPolygon(two, box).pointCount(), two.pointCount());
    EXPECT_EQ(core::erasePolygon(two, {}).pointCount(), two.pointCount());
}

TEST(EditCenterline, CuttingLosesNoPoint)
{
    const Centerline2d cut = core::splitAt(two, {30.2, 43.0});
    ASSERT_EQ(cut.curves.size(), 3U);
    EXPECT_EQ(cut.pointCount(), two.pointCount());
    EXPECT_EQ(cut.curves[1].id, 7);
    EXPECT_EQ(cut.curves[1].pointsPx.back().x(), 30.0);
    EXPECT_EQ(cut.curves[2].pointsPx.front().x(), 31.0);
    EXPECT_EQ(cut.curves[2].radiusPx.size(), cut.curves[2].pointsPx.size());
}

TEST(EditCenterline, CuttingAtAnEndOrFarAwayChangesNothing)
{
    EXPECT_EQ(core::splitAt(two, {0.0, 10.0}).curves.size(), 2U);
    EXPECT_EQ(core::splitAt(two, {100.0, 10.0}).curves.size(), 2U);
    EXPECT_EQ(core::splitAt(two, {50.0, 300.0}).curves.size(), 2U);
    EXPECT_TRUE(core::splitAt({}, {0.0, 0.0}).curves.empty());
}

TEST(EditCenterline, ACurveMarkedAsNoVesselGoesByItsId)
{
    const int id = core::curveAt(two, {60.0, 38.0});
    EXPECT_EQ(id, 7);
    const Centerline2d rest = core::removeCurve(two, id);
    ASSERT_EQ(rest.curves.size(), 1U);
    EXPECT_EQ(rest.curves[0].id, 3);
    EXPECT_EQ(core::curveAt(two, {60.0, 200.0}), -1);
}

TEST(EditCenterline, ADrawnCurveIsCenteredOnItsVessel)
{
    const core::ImageF frame = test::drawnFrame(120, 60, {test::line({-20, 30}, {140, 30})}, 3.0);
    core::ImageF opacity = frame;
    for (float& value : opacity.pixels) {
        value = 120.0F - value;
    }
    const Centerline2d drawn = core::addDrawnCurve(two, {{10.0, 31.5}, {60.0, 28.6}, {110.0, 31.3}}, opacity);
    ASSERT_EQ(drawn.curves.size(), 3U);
    EXPECT_EQ(drawn.curves[2].id, 8);
    const Curve2d& curve = drawn.curves[2];
    EXPECT_NEAR(curve.pointsPx[curve.pointsPx.size() / 2].y(), 30.0, 0.2);
    EXPECT_NEAR(curve.radiusPx[curve.radiusPx.size() / 2], 3.0, 0.5);
    EXPECT_TRUE(core::addDrawnCurve({}, {{10.0, 10.0}}).curves.empty());
}

}   // namespace
