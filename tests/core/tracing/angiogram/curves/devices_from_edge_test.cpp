#include "core/tracing/angiogram/curves/devices_from_edge.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

using namespace angiopose;

namespace {

using core::Curve2d;

const core::Mask2d field(512, 512, 255);

/// A curve from x = 3 that is straight for `straightPx` and winding after that.
Curve2d catheterWithVessel(double straightPx, double endRadiusPx)
{
    Curve2d curve{7, {}, {}};
    for (double x = 3.0; x < 400.0; x += 1.0) {
        const double beyond = std::max(0.0, x - straightPx);
        curve.pointsPx.emplace_back(x, 200.0 + 12.0 * std::sin(0.05 * beyond));
        curve.radiusPx.push_back(beyond > 0.0 ? endRadiusPx : 2.0);
    }
    return curve;
}

TEST(DevicesFromRim, ACatheterIsOneThoughItsTipLiesInAVessel)
{
    Curve2d turned = catheterWithVessel(300.0, 4.0);
    std::reverse(turned.pointsPx.begin(), turned.pointsPx.end());
    std::reverse(turned.radiusPx.begin(), turned.radiusPx.end());
    turned.id = 9;
    EXPECT_EQ(core::findDevicesFromEdge({{catheterWithVessel(300.0, 4.0), turned}}, field), (std::vector<int>{7, 9}));
}

TEST(DevicesFromRim, VesselsThatBeginEvenlyAreNone)
{
    EXPECT_TRUE(core::findDevicesFromEdge({{catheterWithVessel(0.0, 2.0)}}, field).empty());
    EXPECT_TRUE(core::findDevicesFromEdge({{catheterWithVessel(130.0, 2.0)}}, field).empty());
    EXPECT_TRUE(core::findDevicesFromEdge({{Curve2d{}}}, field).empty());
}

TEST(DevicesFromRim, InsideTheFieldNothingIsSaid)
{
    Curve2d inside = catheterWithVessel(300.0, 4.0);
    for (Eigen::Vector2d& point : inside.pointsPx) {
        point.x() += 60.0;
    }
    EXPECT_TRUE(core::findDevicesFromEdge({{inside}}, field).empty());
}

}   // namespace
