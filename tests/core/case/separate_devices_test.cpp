#include "core/case/separate_devices.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

Curve2d curveWith(int id, std::vector<Eigen::Vector2d> points)
{
    return {id, std::move(points), {}};
}

TEST(DevicesApart, ComeTogetherAgain)
{
    const Centerline2d curves{{curveWith(1, {{0, 0}}), curveWith(2, {{1, 1}}), curveWith(3, {{2, 2}})}};
    const SeparatedCurves separated = separateDevices(curves, {2, 77});
    EXPECT_EQ(curveIds(separated.vessels), (std::vector{1, 3}));
    EXPECT_EQ(curveIds(separated.devices), std::vector{2});
    EXPECT_EQ(curveIds(allCurves(separated)), (std::vector{1, 3, 2}));
}

TEST(DevicesApart, PiecesOfADeviceAreDevicesAndNewVesselsAreNone)
{
    const SeparatedCurves before{{{curveWith(1, {{0, 0}, {9, 9}})}},
                                 {{curveWith(2, {{1, 1}, {2, 2}, {3, 3}, {4, 4}})}}};
    const Centerline2d edited{{curveWith(1, {{0, 0}}), curveWith(2, {{1, 1}, {2, 2}}), curveWith(3, {{3, 3}, {4, 4}}),
                               curveWith(4, {{9, 9}}), curveWith(5, {})}};
    EXPECT_EQ(devicesAfterEdit(before, edited), (std::vector{2, 3}));
}

}   // namespace
}   // namespace angiopose::core
