#include "core/tracing/angiogram/drawing/live_wire.h"

#include "tests/support/drawn_vessels.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using core::ImageF;
using core::LiveWire;
using test::Path;

/// Vesselness of 1 on the axis of the paths, falling to 0 within 3 px.
ImageF vesselnessOf(int width, int height, const std::vector<Path>& paths)
{
    ImageF vesselness(width, height);
    test::forEachPixel(width, height, [&](int x, int y) {
        for (const Path& path : paths) {
            const auto strength = static_cast<float>(1.0 - test::distanceTo(path, {x, y}) / 3.0);
            vesselness.at(x, y) = std::max(vesselness.at(x, y), strength);
        }
    });
    return vesselness;
}

TEST(LiveWire, FollowsTheVesselRoundTheDeformation)
{
    const Path ring = test::circle({100.0, 100.0}, 60.0);
    LiveWire wire(vesselnessOf(200, 200, {ring}));
    wire.setAnchor({162.0, 101.0});
    const auto path = wire.pathTo({42.0, 108.0});
    ASSERT_GT(path.size(), 120U) << "the chord would be shorter than the arc";
    for (const Eigen::Vector2d& point : path) {
        EXPECT_LT(test::distanceTo(ring, point), 1.5);
    }
    EXPECT_LT((path.front() - Eigen::Vector2d(160.0, 100.0)).norm(), 2.0) << "the anchor snaps to the vessel";
    EXPECT_LT(test::distanceTo(ring, path.back()), 1.0) << "and so does the pointer";
}

TEST(LiveWire, PathsAreOfUnbrokenStepsAndOfLeastCostBothWays)
{
    LiveWire wire(vesselnessOf(120, 90, {test::line({5, 5}, {110, 30}), test::line({110, 30}, {20, 80})}));
    wire.setAnchor({5.0, 5.0});
    const auto there = wire.pathTo({20.0, 80.0});
    for (std::size_t i = 1; i < there.size(); ++i) {
        EXPECT_LT((there[i] - there[i - 1]).norm(), 1.5);
        EXPECT_GT((there[i] - there[i - 1]).norm(), 0.5);
    }
    wire.setAnchor(there.back());
    const auto back = wire.pathTo(there.front());
    EXPECT_NEAR(static_cast<double>(back.size()), static_cast<double>(there.size()), 3.0);
}

TEST(LiveWire, LaterMovesAgreeWithASearchOfTheirOwn)
{
    const ImageF vesselness =
        vesselnessOf(150, 150, {test::circle({70.0, 80.0}, 50.0), test::line({0, 0}, {149, 120})});
    LiveWire moved(vesselness);
    moved.setAnchor({120.0, 80.0});
    for (const Eigen::Vector2d& pointer : {Eigen::Vector2d(100, 120), {70, 131}, {10, 20}, {149, 0}}) {
        (void)moved.pathTo(pointer);
    }
    LiveWire fresh(vesselness);
    fresh.setAnchor({120.0, 80.0});
    EXPECT_EQ(moved.pathTo({21.0, 80.0}), fresh.pathTo({21.0, 80.0}));
}

TEST(LiveWire, StaysInTheImageAndAsksForAnAnchor)
{
    LiveWire wire(vesselnessOf(40, 30, {test::line({0, 15}, {39, 15})}));
    EXPECT_TRUE(wire.pathTo({5.0, 5.0}).empty());
    wire.setAnchor({-50.0, 15.0});
    for (const Eigen::Vector2d& point : wire.pathTo({500.0, -500.0})) {
        EXPECT_TRUE(point.x() >= 0.0 && point.y() >= 0.0 && point.x() <= 39.0 && point.y() <= 29.0);
    }
    LiveWire nothing((ImageF()));
    nothing.setAnchor({1.0, 1.0});
    EXPECT_TRUE(nothing.pathTo({2.0, 2.0}).empty());
}

TEST(LiveWire, TheLineIsStraightUntilTheSearchArrives)
{
    Path arc = test::circle({750.0, 450.0}, 100.0);
    arc.resize(46);   // the lower half of the circle
    LiveWire wire(vesselnessOf(900, 900, {arc}));
    wire.setAnchor({20.0, 450.0});
    const auto lowest = [&] {
        double y = 0.0;
        for (const Eigen::Vector2d& point : wire.pathTo({850.0, 450.0})) {
            y = std::max(y, point.y());
        }
        return y;
    };
    EXPECT_LT(lowest(), 455.0);
    for (int call = 0; call < 4; ++call) {
        (void)lowest();
    }
    EXPECT_GT(lowest(), 540.0) << "along the arc";
}

}   // namespace
