#include "core/geometry/pose_difference.h"

#include <gtest/gtest.h>
#include <numbers>

using namespace angiopose;

namespace {

using namespace core;

TEST(PoseDifference, TellsShiftAndTurnAboutThePivotApart)
{
    const Eigen::Vector3d pivot(10.0, 20.0, 30.0);
    const RigidTransform a{expSo3({0.1, -0.2, 0.3}), {5.0, 6.0, 700.0}};
    RigidTransform b;
    b.rotation = expSo3({0.0, 0.0, 5.0 * std::numbers::pi / 180.0}) * a.rotation;
    b.translation = a * pivot + Eigen::Vector3d(3.0, 4.0, -7.0) - b.rotation * pivot;

    const PoseDifference difference = differenceBetween(a, b, pivot);

    EXPECT_NEAR(difference.inPlaneMm, 5.0, 1e-9);
    EXPECT_NEAR(difference.depthMm, -7.0, 1e-9);
    EXPECT_NEAR(difference.rotationDeg, 5.0, 1e-9);
    EXPECT_NEAR(differenceBetween(b, a, pivot).depthMm, 7.0, 1e-9);
    EXPECT_EQ(differenceBetween(a, a, pivot).inPlaneMm, 0.0);
}

}   // namespace
