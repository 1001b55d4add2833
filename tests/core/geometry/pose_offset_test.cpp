#include "core/geometry/pose_offset.h"

#include "core/geometry/c_arm.h"
#include "tests/support/matchers.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

const ProjectionCamera squareCamera{-2281.0, 2281.0, 255.5, 255.5, 512, 512};
const Eigen::Vector3d pivot(80.0, 90.0, -550.0);

CArm isocentricCArm(double primaryDeg, double secondaryDeg)
{
    CArm cArm;
    cArm.sourceToIsocenterMm = {750.0, Origin::User, ""};
    cArm.primaryAngleDeg = {primaryDeg, Origin::User, ""};
    cArm.secondaryAngleDeg = {secondaryDeg, Origin::User, ""};
    return cArm;
}

RigidTransform poseAtAngles(double primaryDeg, double secondaryDeg)
{
    return cameraFromPatient(isocentricCArm(primaryDeg, secondaryDeg), pivot).value();
}

TEST(PoseOffset, IsRecoveredFromTheTwoPoses)
{
    const PoseOffset offset{3.0, -2.0, 15.0, 7.0, -11.0, 5.0};
    for (const double fx : {-2281.0, 2281.0}) {
        ProjectionCamera camera = squareCamera;
        camera.fx = fx;
        const RigidTransform reference = poseAtAngles(-20.0, 10.0);
        const PoseOffset back = offsetBetween(reference, applyOffset(reference, offset, pivot, camera), pivot, camera);
        EXPECT_NEAR(back.rightMm, 3.0, 1e-9);
        EXPECT_NEAR(back.upMm, -2.0, 1e-9);
        EXPECT_NEAR(back.alongRayMm, 15.0, 1e-9);
        EXPECT_NEAR(back.rollDeg, 7.0, 1e-9);
        EXPECT_NEAR(back.laoRaoDeg, -11.0, 1e-9);
        EXPECT_NEAR(back.craCauDeg, 5.0, 1e-9);
    }
}

TEST(PoseOffset, ShiftsMoveThePivotOnScreenAsNamed)
{
    for (const double fx : {-2281.0, 2281.0}) {
        ProjectionCamera camera = squareCamera;
        camera.fx = fx;
        const RigidTransform reference = poseAtAngles(0.0, 0.0);
        const Eigen::Vector2d before = *project(camera, reference * pivot);
        const Eigen::Vector2d right = *project(camera, applyOffset(reference, {.rightMm = 5.0}, pivot, camera) * pivot);
        const Eigen::Vector2d up = *project(camera, applyOffset(reference, {.upMm = 5.0}, pivot, camera) * pivot);
        EXPECT_GT(right.x(), before.x() + 5.0);
        EXPECT_LT(up.y(), before.y() - 5.0);
    }
}

TEST(PoseOffset, RollIsClockwiseOnScreen)
{
    for (const double fx : {-2281.0, 2281.0}) {
        ProjectionCamera camera = squareCamera;
        camera.fx = fx;
        const RigidTransform reference = poseAtAngles(0.0, 0.0);
        const Eigen::Vector3d above = pivot + Eigen::Vector3d(0.0, 0.0, 20.0);   // head: up on the screen
        const Eigen::Vector2d after =
            *project(camera, applyOffset(reference, {.rollDeg = 90.0}, pivot, camera) * above);
        EXPECT_GT(after.x(), camera.cx + 10.0);
    }
}

TEST(PoseOffset, AnglesActLikeTheCArm)
{
    EXPECT_TRUE(test::nearPose(applyOffset(poseAtAngles(0.0, 0.0), {.laoRaoDeg = 25.0}, pivot, squareCamera),
                               poseAtAngles(25.0, 0.0), 1e-9, 1e-9, pivot));
    EXPECT_TRUE(test::nearPose(applyOffset(poseAtAngles(0.0, 0.0), {.craCauDeg = 25.0}, pivot, squareCamera),
                               poseAtAngles(0.0, 25.0), 1e-9, 1e-9, pivot));
}

}   // namespace
