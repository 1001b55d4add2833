#include "ui/views/tools/wire_path.h"

#include <gtest/gtest.h>
#include <cmath>

namespace angiopose::ui {
namespace {

/// A vessel along row 20 that turns up at column 60.
core::ImageF corner()
{
    core::ImageF vesselness(100, 100, 0.0F);
    for (int x = 10; x <= 60; ++x) {
        vesselness.at(x, 20) = 1.0F;
    }
    for (int y = 20; y <= 80; ++y) {
        vesselness.at(60, y) = 1.0F;
    }
    return vesselness;
}

TEST(LiveWirePath, FollowsTheVesselFromAnchorToAnchor)
{
    core::LiveWire wire(corner());
    LiveWirePath path;
    path.addAnchor({12.0, 22.0}, &wire, false);
    EXPECT_EQ(path.anchors().front(), Eigen::Vector2d(12.0, 20.0)) << "snapped to the vessel";
    path.previewTo({61.0, 70.0}, &wire, false);
    EXPECT_GT(path.preview().size(), 90U) << "round the corner";
    path.addAnchor({61.0, 70.0}, &wire, false);
    for (const Eigen::Vector2d& point : path.points()) {
        EXPECT_TRUE(std::abs(point.y() - 20.0) < 1.5 || std::abs(point.x() - 60.0) < 1.5) << point.transpose();
    }
}

TEST(LiveWirePath, TakesBackAnchorByAnchor)
{
    core::LiveWire wire(corner());
    LiveWirePath path;
    path.addAnchor({12.0, 20.0}, &wire, false);
    path.addAnchor({40.0, 20.0}, &wire, false);
    path.addAnchor({90.0, 90.0}, &wire, true);
    EXPECT_EQ(path.anchors().back(), Eigen::Vector2d(90.0, 90.0)) << "straight, where asked";
    path.undoStep(&wire);
    EXPECT_EQ(path.anchors().back(), Eigen::Vector2d(40.0, 20.0));
    path.addAnchor({60.0, 20.0}, &wire, false);
    EXPECT_NEAR(path.points().back().x(), 60.0, 1.0);
    path.undoStep(&wire);
    path.undoStep(&wire);
    path.undoStep(&wire);
    path.undoStep(&wire);
    EXPECT_TRUE(path.isEmpty());
}

TEST(LiveWirePath, IsStraightWithoutAWire)
{
    LiveWirePath path;
    path.addAnchor({0.0, 0.0}, nullptr, false);
    path.addAnchor({10.0, 5.0}, nullptr, false);
    EXPECT_EQ(path.points(), (LiveWirePath::Points{{0.0, 0.0}, {10.0, 5.0}}));
    path.clear();
    path.previewTo({1.0, 1.0}, nullptr, false);
    EXPECT_TRUE(path.preview().empty());
}

}   // namespace
}   // namespace angiopose::ui
