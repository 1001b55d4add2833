#include "core/tracing/angiogram/curves/vessel_trunk.h"

#include "tests/support/drawn_vessels.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

core::Curve2d curve(int id, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radiusPx)
{
    core::Curve2d result{id, {}, {}};
    for (int i = 0; i <= 100; ++i) {
        result.pointsPx.push_back(from + 0.01 * i * (to - from));
        result.radiusPx.push_back(radiusPx);
    }
    return result;
}

TEST(WidestTrunk, IsTheWidestCurveThatBranches)
{
    const core::Curve2d trunk = curve(3, {50, 50}, {250, 50}, 6.0);
    const core::Curve2d first = curve(4, {100, 57}, {120, 200}, 3.0);
    const core::Curve2d second = curve(5, {200, 150}, {180, 42}, 3.0);
    const core::Curve2d catheter = curve(6, {0, 20}, {300, 180}, 8.0);   // crosses all of them but has no branches
    EXPECT_EQ(core::findWidestTrunk({{trunk, first, second, catheter}}), 3);
    EXPECT_EQ(core::findWidestTrunk({{trunk, first, catheter}}), std::nullopt)
        << "one touches a catheter's tip as well";
    EXPECT_EQ(core::findWidestTrunk({}), std::nullopt);
    core::Curve2d unmeasured = trunk;
    unmeasured.radiusPx.clear();
    EXPECT_EQ(core::findWidestTrunk({{unmeasured, first, second}}), std::nullopt);
}

}   // namespace
