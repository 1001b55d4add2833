#include "core/tracing/angiogram/curves/devices_apart.h"

#include "core/tracing/angiogram/curves/suspect_curves.h"

#include <gtest/gtest.h>
#include <cmath>

using namespace angiopose;

namespace {

using core::Curve2d;
using core::Mask2d;

const Mask2d field(512, 512, 255);

/// From x = 3 on: straight for `straightPx`, winding after that.
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

TEST(DevicesApart, TheCatheterIsCutFromTheVesselItsTipLiesIn)
{
    const auto parts = core::withDevicesApart({catheterWithVessel(200.0, 4.0)}, field);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].id, 1);
    EXPECT_EQ(parts[1].id, 2);
    EXPECT_NEAR(parts[0].pointsPx.back().x(), 200.0, 25.0);
    EXPECT_EQ(parts[0].pointsPx.size(), parts[0].radiusPx.size());
    EXPECT_NEAR(parts[0].lengthPx() + parts[1].lengthPx(), catheterWithVessel(200.0, 4.0).lengthPx(), 1e-9);
    EXPECT_EQ(core::suspectCurves({parts}, 512), std::vector<int>{1});
}

TEST(DevicesApart, FromEitherEnd)
{
    Curve2d turned = catheterWithVessel(200.0, 4.0);
    std::reverse(turned.pointsPx.begin(), turned.pointsPx.end());
    std::reverse(turned.radiusPx.begin(), turned.radiusPx.end());
    EXPECT_EQ(core::withDevicesApart({turned}, field).size(), 2U);
}

TEST(DevicesApart, VesselsStayWhole)
{
    const auto winding = core::withDevicesApart({catheterWithVessel(0.0, 2.0)}, field);
    ASSERT_EQ(winding.size(), 1U);
    EXPECT_EQ(winding[0].pointsPx, catheterWithVessel(0.0, 2.0).pointsPx);
    const auto shortStart = core::withDevicesApart({catheterWithVessel(60.0, 2.0)}, field);
    EXPECT_EQ(shortStart.size(), 1U);
}

TEST(DevicesApart, InsideTheFieldNothingIsCut)
{
    Curve2d inside = catheterWithVessel(200.0, 4.0);
    for (Eigen::Vector2d& point : inside.pointsPx) {
        point.x() += 60.0;
    }
    EXPECT_EQ(core::withDevicesApart({inside}, field).size(), 1U);
}

}   // namespace
