#include "core/geometry/c_arm.h"

#include <gtest/gtest.h>
#include <limits>
#include <tuple>

using namespace angiopose;

namespace {

using namespace core;

CArm cArmAt(double primaryDeg, double secondaryDeg)
{
    CArm cArm;
    cArm.sourceToDetectorMm = {1000.0, Origin::User, ""};
    cArm.sourceToIsocenterMm = {750.0, Origin::User, ""};
    cArm.columnSpacingMm = {0.4, Origin::User, ""};
    cArm.rowSpacingMm = {0.4, Origin::User, ""};
    cArm.primaryAngleDeg = {primaryDeg, Origin::User, ""};
    cArm.secondaryAngleDeg = {secondaryDeg, Origin::User, ""};
    return cArm;
}

/// Projection of a patient point (LPS mm, relative to the isocenter), relative to the image center: right and up, px.
Eigen::Vector2d onScreen(const CArm& cArm, const Eigen::Vector3d& offset)
{
    const Eigen::Vector3d isocenter(12.0, -200.0, 900.0);
    const ProjectionCamera camera = cameraFromCArm(cArm, 513, 513).value();
    const RigidTransform pose = cameraFromPatient(cArm, isocenter).value();
    const Eigen::Vector2d pixel = *project(camera, pose * (isocenter + offset).eval());
    return {pixel.x() - camera.cx, camera.cy - pixel.y()};
}

const Eigen::Vector3d left(10.0, 0.0, 0.0);
const Eigen::Vector3d posterior(0.0, 10.0, 0.0);
const Eigen::Vector3d head(0.0, 0.0, 10.0);

TEST(CArm, FrontalViewShowsPatientLeftOnTheRightAndHeadUp)
{
    const CArm cArm = cArmAt(0.0, 0.0);
    const double expected = 1000.0 / 0.4 * 10.0 / 750.0;
    EXPECT_TRUE(onScreen(cArm, left).isApprox(Eigen::Vector2d(expected, 0.0), 1e-9));
    EXPECT_TRUE(onScreen(cArm, head).isApprox(Eigen::Vector2d(0.0, expected), 1e-9));
    EXPECT_LT(onScreen(cArm, posterior).norm(), 1e-9);
    EXPECT_DOUBLE_EQ((cameraFromPatient(cArm, {0, 0, 0}).value() * left).x(), -10.0);   // manual check of §5.3
}

TEST(CArm, LateralViewFromTheLeftShowsPosteriorOnTheRight)
{
    const CArm cArm = cArmAt(90.0, 0.0);
    EXPECT_TRUE(detectorDirection(90.0, 0.0).isApprox(Eigen::Vector3d(1.0, 0.0, 0.0), 1e-12));
    EXPECT_GT(onScreen(cArm, posterior).x(), 10.0);
    EXPECT_NEAR(onScreen(cArm, posterior).y(), 0.0, 1e-9);
    EXPECT_LT(onScreen(cArm, left).norm(), 1e-9);
}

TEST(CArm, CranialViewPutsTheDetectorTowardsTheHead)
{
    EXPECT_GT(detectorDirection(0.0, 30.0).z(), 0.49);
    const CArm cArm = cArmAt(0.0, 30.0);
    EXPECT_GT(onScreen(cArm, head).y(), 10.0);
    EXPECT_GT(onScreen(cArm, posterior).y(), 5.0);   // view from the head down: posterior moves up
    EXPECT_GT(onScreen(cArm, left).x(), 10.0);
}

TEST(CArm, ObliqueViewKeepsHeadUpAndLeftRight)
{
    const CArm cArm = cArmAt(-30.0, 20.0);
    EXPECT_GT(onScreen(cArm, head).y(), 10.0);
    EXPECT_GT(onScreen(cArm, left).x(), 10.0);
    EXPECT_LT(detectorDirection(-30.0, 20.0).x(), 0.0);   // RAO: toward the patient's right
}

TEST(CArm, PoseIsAlwaysAProperRotation)
{
    for (const auto& [primary, secondary] :
         {std::tuple{0.0, 0.0}, {90.0, 0.0}, {0.0, 30.0}, {-30.0, 20.0}, {170.0, -80.0}}) {
        const RigidTransform pose = cameraFromPatient(cArmAt(primary, secondary), {1.0, 2.0, 3.0}).value();
        EXPECT_TRUE(isRigid(pose, 1e-12));
        EXPECT_NEAR((pose * Eigen::Vector3d(1.0, 2.0, 3.0)).z(), 750.0, 1e-9);
    }
}

TEST(CArm, RollTurnsTheImageClockwise)
{
    CArm cArm = cArmAt(0.0, 0.0);
    cArm.rollDeg = {90.0, Origin::User, ""};
    EXPECT_GT(onScreen(cArm, head).x(), 10.0);   // up becomes right
    EXPECT_LT(onScreen(cArm, left).y(), -10.0);
    cArm.mirrored = {true, Origin::User, ""};
    EXPECT_GT(onScreen(cArm, head).x(), 10.0);
}

TEST(CArm, MirroredExportHasPositiveFocalLength)
{
    CArm cArm = cArmAt(0.0, 0.0);
    cArm.mirrored = {true, Origin::User, ""};
    EXPECT_GT(cameraFromCArm(cArm, 512, 512).value().fx, 0.0);
    EXPECT_LT(onScreen(cArm, left).x(), -10.0);
}

TEST(CArm, MissingValuesAreNamed)
{
    CArm cArm = cArmAt(0.0, 0.0);
    cArm.columnSpacingMm = {};
    const auto camera = cameraFromCArm(cArm, 512, 512);
    ASSERT_FALSE(camera);
    EXPECT_NE(camera.error().message.text().find("pixel spacing"), std::string::npos);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ("geometry.isocentre-not-finite", cameraFromPatient(cArm, {nan, 0, 0}).error().message.id());
    cArm.secondaryAngleDeg.value = nan;
    EXPECT_EQ("geometry.angles-missing", cameraFromPatient(cArm, {0, 0, 0}).error().message.id());
    cArm.secondaryAngleDeg = {};
    EXPECT_FALSE(cameraFromPatient(cArm, {0, 0, 0}));
}

TEST(CArm, TurnsByTheIncrementsOfAFrame)
{
    const CArm turned = rotateCArm(cArmAt(10.0, -5.0), {20.0, 0.0});
    EXPECT_DOUBLE_EQ(*turned.primaryAngleDeg.value, 30.0);
    EXPECT_DOUBLE_EQ(*turned.secondaryAngleDeg.value, -5.0);
    EXPECT_NE(turned.primaryAngleDeg.basis, "");
    EXPECT_EQ(turned.secondaryAngleDeg.basis, "");
    EXPECT_FALSE(rotateCArm({}, {20.0, 3.0}).primaryAngleDeg.value);
}

}   // namespace
