#include "core/geometry/camera_uncertainty.h"

#include <gtest/gtest.h>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr ProjectionCamera usualCamera{-2500.0, 2500.0, 511.5, 511.5, 1024, 1024};

CArm cArmFrom(Origin distance, Origin spacing, Origin principalPoint)
{
    CArm cArm;
    cArm.sourceToDetectorMm.origin = distance;
    cArm.columnSpacingMm.origin = spacing;
    cArm.principalPointPx.origin = principalPoint;
    return cArm;
}

TEST(CameraUncertainty, IsThatOfDistanceAndSpacingTogether)
{
    const CameraUncertainty spread =
        uncertaintyByOrigin(cArmFrom(Origin::Header, Origin::Header, Origin::Missing), usualCamera);
    EXPECT_NEAR(spread.relativeFocalStd, std::hypot(0.025, 0.015), 1e-12);
    EXPECT_NEAR(spread.principalPx, 10.0, 1e-12);
}

TEST(CameraUncertainty, IsWiderWhereAValueIsAssumed)
{
    const CArm reported = cArmFrom(Origin::Header, Origin::User, Origin::User);
    const CArm derived = cArmFrom(Origin::Header, Origin::Derived, Origin::Derived);
    const CArm assumed = cArmFrom(Origin::Assumed, Origin::Derived, Origin::Assumed);
    EXPECT_LT(uncertaintyByOrigin(reported, usualCamera).relativeFocalStd,
              uncertaintyByOrigin(derived, usualCamera).relativeFocalStd);
    EXPECT_LT(uncertaintyByOrigin(derived, usualCamera).relativeFocalStd,
              uncertaintyByOrigin(assumed, usualCamera).relativeFocalStd);
    EXPECT_LT(uncertaintyByOrigin(reported, usualCamera).principalPx,
              uncertaintyByOrigin(assumed, usualCamera).principalPx);
    EXPECT_FALSE(enteredCameraUncertainty(usualCamera).isExact());
    EXPECT_TRUE(CameraUncertainty().isExact());
}

TEST(CameraUncertainty, AnErrorTakesTheCameraToTheTrueOne)
{
    const ProjectionCamera better = applyCameraError(usualCamera, {std::log(1.05), 20.0, -3.0});
    EXPECT_NEAR(better.fx, -2625.0, 1e-9);
    EXPECT_NEAR(better.fy, 2625.0, 1e-9);
    EXPECT_NEAR(better.cx, 531.5, 1e-12);
    EXPECT_NEAR(better.cy, 508.5, 1e-12);
}

TEST(CameraUncertainty, AnErrorGoesToTheLessCertainOfDistanceAndSpacing)
{
    const CameraError error{std::log(1.05), 20.0, -3.0};
    for (const Origin spacing : {Origin::Header, Origin::Assumed}) {
        CArm cArm = cArmFrom(Origin::Header, spacing, Origin::Missing);
        cArm.sourceToDetectorMm.value = 1000.0;
        cArm.columnSpacingMm.value = cArm.rowSpacingMm.value = 0.4;
        cArm.rowSpacingMm.origin = spacing;
        const ProjectionCamera given = cameraFromCArm(cArm, 1024, 1024).value();
        const CArm better = applyCameraError(cArm, given, error, "images");
        const ProjectionCamera camera = cameraFromCArm(better, 1024, 1024).value();
        const ProjectionCamera wanted = applyCameraError(given, error);
        EXPECT_NEAR(camera.fx, wanted.fx, 1e-9);
        EXPECT_NEAR(camera.fy, wanted.fy, 1e-9);
        EXPECT_NEAR(camera.cx, wanted.cx, 1e-9);
        EXPECT_NEAR(camera.cy, wanted.cy, 1e-9);
        const bool isDistance = spacing == Origin::Header;
        EXPECT_EQ(better.sourceToDetectorMm.origin, isDistance ? Origin::Derived : Origin::Header);
        EXPECT_EQ(better.columnSpacingMm.origin, isDistance ? Origin::Header : Origin::Derived);
        EXPECT_EQ(better.principalPointPx.basis, "images");
    }
}

}   // namespace
}   // namespace angiopose::core
