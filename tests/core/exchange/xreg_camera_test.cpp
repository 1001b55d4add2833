#include "core/exchange/projection_matrix.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <random>

using namespace angiopose;

namespace {

using namespace core;

/// The projection of xReg according to its source code (perspective transform of its camera model): applies the
/// extrinsic matrix to world points, measures z from the source, applies the intrinsic matrix and divides by the third
/// coordinate.
Eigen::Vector2d pixelOfXreg(const XregCamera& camera, const RigidTransform& volumeFromWorld,
                            const Eigen::Vector3d& point)
{
    const Eigen::Vector4d inWorld = volumeFromWorld.matrix().inverse() * point.homogeneous();
    Eigen::Vector3d inCamera = (camera.cameraFromWorld.matrix() * inWorld).head<3>();
    if (camera.frame == XregFrame::OriginOnDetector) {
        const double focal = 0.5 * (std::abs(camera.intrinsic(0, 0) * camera.columnSpacingMm) +
                                    std::abs(camera.intrinsic(1, 1) * camera.rowSpacingMm));
        inCamera(2) = focal - inCamera(2);
    }
    const Eigen::Vector3d index = camera.intrinsic * inCamera;
    return {index(0) / index(2), index(1) / index(2)};
}

/// A camera as xReg sets it up from a header: principal point at the center of the image, negative focal lengths if the
/// detector is at negative z.
XregCamera cameraOf(XregFrame frame)
{
    XregCamera camera;
    camera.frame = frame;
    camera.columns = 1536;
    camera.rows = 1512;
    camera.columnSpacingMm = 0.194;
    camera.rowSpacingMm = 0.2;
    const double sign = frame == XregFrame::DetectorAtNegativeZ ? -1.0 : 1.0;
    camera.intrinsic(0, 0) = sign * 1020.0 / camera.columnSpacingMm;
    camera.intrinsic(1, 1) = sign * 1020.0 / camera.rowSpacingMm;
    camera.intrinsic(0, 2) = 0.5 * (camera.columns - 1);
    camera.intrinsic(1, 2) = 0.5 * (camera.rows - 1);
    return camera;
}

/// Pose of the patient in the camera frame, 700 mm from the source.
RigidTransform patientIn(XregFrame frame)
{
    const double z = frame == XregFrame::DetectorAtNegativeZ   ? -700.0
                     : frame == XregFrame::DetectorAtPositiveZ ? 700.0
                                                               : 320.0;
    return {expSo3({0.7, -0.4, 1.9}), {12.0, -31.0, z}};
}

class XregCameraOf : public testing::TestWithParam<XregFrame> {};

TEST_P(XregCameraOf, ProjectsAsItsOwnFormula)
{
    XregCamera camera = cameraOf(GetParam());
    camera.cameraFromWorld = {expSo3({0.2, 0.9, -0.3}), {5.0, 60.0, -11.0}};
    const RigidTransform volumeFromWorld = patientIn(GetParam()).inverse() * camera.cameraFromWorld;
    const auto posedCamera = posedCameraFromXreg(camera, volumeFromWorld);
    ASSERT_TRUE(posedCamera);
    EXPECT_GT(posedCamera.value().camera.fy, 0.0);
    EXPECT_EQ(posedCamera.value().camera.fx < 0.0, GetParam() != XregFrame::DetectorAtPositiveZ);
    EXPECT_NEAR(posedCamera.value().cameraFromPatient.rotation.determinant(), 1.0, 1e-12);
    std::mt19937 chance(7);
    std::uniform_real_distribution<double> coordinate(-90.0, 90.0);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d point(coordinate(chance), coordinate(chance), coordinate(chance));
        const auto pixel = project(posedCamera.value().camera, posedCamera.value().cameraFromPatient * point);
        ASSERT_TRUE(pixel);
        EXPECT_LT((*pixel - pixelOfXreg(camera, volumeFromWorld, point)).norm(), 1e-9);
    }
}

TEST_P(XregCameraOf, GivesItsPoseBack)
{
    XregCamera camera = cameraOf(GetParam());
    camera.cameraFromWorld = {expSo3({0.2, 0.9, -0.3}), {5.0, 60.0, -11.0}};
    const RigidTransform volumeFromWorld = patientIn(GetParam()).inverse() * camera.cameraFromWorld;
    const auto posedCamera = posedCameraFromXreg(camera, volumeFromWorld);
    const auto back = xregPose(posedCamera.value().cameraFromPatient, camera);
    ASSERT_TRUE(back);
    EXPECT_LT((back.value().matrix() - volumeFromWorld.matrix()).cwiseAbs().maxCoeff(), 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Frames, XregCameraOf,
                         testing::Values(XregFrame::DetectorAtNegativeZ, XregFrame::DetectorAtPositiveZ,
                                         XregFrame::OriginOnDetector));

TEST(XregCameraOfOurs, IsTheSameProjectionForEitherDisplay)
{
    const RigidTransform pose{expSo3({-1.2, 0.3, 0.5}), {-8.0, 14.0, 765.0}};
    for (const double fx : {-2281.0, 2281.0}) {
        const ProjectionCamera ours{fx, 2290.0, 254.0, 251.5, 512, 500};
        const XregCamera theirs = xregCamera(ours, 1000.0);
        const auto volumeFromWorld = xregPose(pose, theirs);
        ASSERT_TRUE(volumeFromWorld);
        for (const Eigen::Vector3d& point :
             {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(40, -25, 60), Eigen::Vector3d(-70, 5, -9)}) {
            EXPECT_LT((pixelOfXreg(theirs, volumeFromWorld.value(), point) - *project(ours, pose * point)).norm(),
                      1e-9);
        }
        EXPECT_NEAR(theirs.columnSpacingMm * 2281.0, 1000.0, 1e-9);
        EXPECT_EQ(theirs.intrinsic(0, 0), ours.fx);
        EXPECT_EQ(theirs.intrinsic(1, 1) < 0.0, fx < 0.0);   // both negative or both positive, as in xReg
    }
}

TEST(XregCameraOfOurs, SinglePrecisionOfItsFilesIsNoSkew)
{
    XregCamera camera = cameraOf(XregFrame::DetectorAtNegativeZ);
    camera.cameraFromWorld.rotation = expSo3({0.2, 0.9, -0.3}).cast<float>().cast<double>();
    camera.intrinsic = camera.intrinsic.cast<float>().cast<double>().eval();
    const auto posedCamera = posedCameraFromXreg(camera, patientIn(camera.frame).inverse());
    ASSERT_TRUE(posedCamera);
    EXPECT_TRUE(isRigid(posedCamera.value().cameraFromPatient, 1e-12));
}

}   // namespace
