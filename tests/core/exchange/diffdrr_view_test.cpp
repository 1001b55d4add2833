#include "core/exchange/diffdrr_view.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <random>

using namespace angiopose;

namespace {

using namespace core;

/// Change of frame applied before the pose, as in DiffDRR's volume reader.
Eigen::Matrix4d orientationMatrix(DiffDrrOrientation orientation)
{
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    if (orientation == DiffDrrOrientation::Ap) {
        matrix << 1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1;
    } else if (orientation == DiffDrrOrientation::Pa) {
        matrix << 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1;
    }
    return matrix;
}

/// Point in the world frame of DiffDRR: RAS with the origin at the center of the volume.
Eigen::Vector4d inWorld(const DiffDrrView& view, const Eigen::Vector3d& lps)
{
    const Eigen::Vector3d& c = view.volumeCenterInPatient;
    return {c.x() - lps.x(), c.y() - lps.y(), lps.z() - c.z(), 1.0};
}

/// DiffDRR's projection of points (`perspective_projection`): applies the inverse of pose and orientation, then the
/// intrinsic matrix, divides, and counts from the upper left corner. Its pixel coordinates start at the corner of the
/// first pixel, ours at its center.
Eigen::Vector2d projected(const DiffDrrView& view, const Eigen::Vector3d& lps)
{
    const DiffDrrDetector& d = view.detector;
    const Eigen::Matrix4d extrinsic = (view.pose.matrix() * orientationMatrix(d.orientation)).inverse();
    const Eigen::Vector4d x = extrinsic * inWorld(view, lps);
    Eigen::Matrix3d intrinsic = Eigen::Matrix3d::Identity();
    intrinsic(0, 0) = d.sddMm / d.delxMm;
    intrinsic(1, 1) = d.sddMm / d.delyMm;
    intrinsic(0, 2) = -d.x0Mm / d.delxMm + d.width / 2.0;   // its property x0 is the negative of the given value
    intrinsic(1, 2) = -d.y0Mm / d.delyMm + d.height / 2.0;
    Eigen::Vector3d image = intrinsic * x.head<3>();
    image /= image(2);
    image(1) = d.height - image(1);
    if (d.isXReversed) {
        image(0) = d.width - image(0);
    }
    return {image(0) - 0.5, image(1) - 0.5};
}

/// Center of a detector pixel in the world, as DiffDRR computes its rays: unit steps from the middle, rows and columns
/// against y and x, scaled and shifted by the calibration.
Eigen::Vector4d pixelCenter(const DiffDrrView& view, int row, int column)
{
    const DiffDrrDetector& d = view.detector;
    const auto step = [](int index, int count) {
        const int first = count % 2 ? -(count + 1) / 2 : -count / 2;   // -count // 2 in Python
        return first + index + (count % 2 ? 1.0 : 0.5);
    };
    const double t = -step(row, d.height);
    const double s = d.isXReversed ? -step(column, d.width) : step(column, d.width);
    const Eigen::Vector4d onDetector(s * d.delxMm + d.x0Mm, t * d.delyMm + d.y0Mm, d.sddMm, 1.0);
    return view.pose.matrix() * orientationMatrix(d.orientation) * onDetector;
}

DiffDrrView viewOf(DiffDrrOrientation orientation, bool isXReversed)
{
    DiffDrrView view;
    view.detector = {1020.0, 301, 512, 0.35, 0.4, 3.5, -2.25, isXReversed, orientation};
    const double back = orientation == DiffDrrOrientation::Pa ? -740.0 : 740.0;
    view.pose = orientation == DiffDrrOrientation::None ? diffDrrPose("ZXY", {0.3, -0.2, 0.1}, {5.0, -8.0, -740.0})
                                                        : diffDrrPose("ZXY", {0.3, -0.2, 0.1}, {5.0, back, -8.0});
    view.volumeCenterInPatient = {11.0, -162.5, 1204.25};
    return view;
}

class DiffDrrViewOf : public testing::TestWithParam<std::tuple<DiffDrrOrientation, bool>> {};

TEST_P(DiffDrrViewOf, ProjectsAsItsOwnFormula)
{
    const DiffDrrView view = viewOf(std::get<0>(GetParam()), std::get<1>(GetParam()));
    const PosedCamera posedCamera = posedCameraFromDiffDrr(view);
    EXPECT_NEAR(posedCamera.cameraFromPatient.rotation.determinant(), 1.0, 1e-12);
    EXPECT_GT(posedCamera.camera.fy, 0.0);
    std::mt19937 chance(11);
    std::uniform_real_distribution<double> offset(-80.0, 80.0);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d point =
            view.volumeCenterInPatient + Eigen::Vector3d(offset(chance), offset(chance), offset(chance));
        const auto pixel = project(posedCamera.camera, posedCamera.cameraFromPatient * point);
        ASSERT_TRUE(pixel);
        EXPECT_LT((*pixel - projected(view, point)).norm(), 1e-9);
    }
}

/// The rays cast by DiffDRR end at the pixels of our camera.
TEST_P(DiffDrrViewOf, CastsItsRaysThroughOurPixels)
{
    const DiffDrrView view = viewOf(std::get<0>(GetParam()), std::get<1>(GetParam()));
    const PosedCamera posedCamera = posedCameraFromDiffDrr(view);
    for (const auto& [row, column] : {std::pair{0, 0}, {0, 511}, {300, 0}, {150, 256}, {17, 401}}) {
        const Eigen::Vector4d world = pixelCenter(view, row, column);
        const Eigen::Vector3d& c = view.volumeCenterInPatient;
        const Eigen::Vector3d lps(c.x() - world.x(), c.y() - world.y(), c.z() + world.z());
        const auto pixel = project(posedCamera.camera, posedCamera.cameraFromPatient * lps);
        ASSERT_TRUE(pixel);
        EXPECT_LT((*pixel - Eigen::Vector2d(column, row)).norm(), 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(Detectors, DiffDrrViewOf,
                         testing::Combine(testing::Values(DiffDrrOrientation::None, DiffDrrOrientation::Ap,
                                                          DiffDrrOrientation::Pa),
                                          testing::Bool()));

/// In a frontal view with the head up, the patient's left is on the right of the image, as with xvr's reversed x.
TEST(DiffDrr, FrontAndBackShowThePatientAsItSays)
{
    for (const auto orientation : {DiffDrrOrientation::Ap, DiffDrrOrientation::Pa}) {
        DiffDrrView view;
        view.detector = {1000.0, 401, 401, 0.4, 0.4, 0.0, 0.0, true, orientation};
        view.pose = diffDrrPose("ZXY", {0, 0, 0}, {0, orientation == DiffDrrOrientation::Pa ? -750.0 : 750.0, 0});
        const PosedCamera posedCamera = posedCameraFromDiffDrr(view);
        const auto at = [&](const Eigen::Vector3d& lps) {
            return *project(posedCamera.camera, posedCamera.cameraFromPatient * lps);
        };
        EXPECT_GT(at({10, 0, 0}).x(), at({0, 0, 0}).x());
        EXPECT_LT(at({0, 0, 10}).y(), at({0, 0, 0}).y());
        EXPECT_EQ(posedCamera.camera.fx < 0.0, orientation == DiffDrrOrientation::Pa);   // the detector is in front
    }
}

TEST(DiffDrr, TakesOursAndGivesItBack)
{
    const RigidTransform pose{expSo3({-1.2, 0.3, 0.5}), {-8.0, 14.0, 765.0}};
    for (const double fx : {-2281.0, 2281.0}) {
        const PosedCamera ours{{fx, 2290.0, 254.0, 251.5, 512, 501}, pose};
        const DiffDrrView theirs = diffDrrView(ours, 1020.0, {3.0, -140.0, 980.0});
        EXPECT_NEAR(theirs.pose.rotation.determinant(), 1.0, 1e-12);
        const Eigen::Vector3d point(14.0, -150.0, 12.0);
        EXPECT_LT((projected(theirs, point) - *project(ours.camera, pose * point)).norm(), 1e-9);
        const PosedCamera back = posedCameraFromDiffDrr(theirs);
        EXPECT_LT((back.cameraFromPatient.matrix() - pose.matrix()).cwiseAbs().maxCoeff(), 1e-9);
        EXPECT_NEAR(back.camera.fx, fx, 1e-9);
        EXPECT_NEAR(back.camera.cx, 254.0, 1e-9);
        EXPECT_EQ(back.camera.width, 512);
    }
}

/// The translation is given before the rotation: the source keeps its distance from the origin.
TEST(DiffDrr, EulerAnglesTurnTheTranslationToo)
{
    const Eigen::Vector3d angles(0.4, -0.7, 1.1), translation(3.0, 850.0, -20.0);
    const RigidTransform pose = diffDrrPose("ZXY", angles, translation);
    const auto turn = [](double a, const Eigen::Vector3d& axis) {
        return Eigen::AngleAxisd(a, axis).toRotationMatrix();
    };
    const Eigen::Matrix3d R = turn(0.4, Eigen::Vector3d::UnitZ()) * turn(-0.7, Eigen::Vector3d::UnitX()) *
                              turn(1.1, Eigen::Vector3d::UnitY());
    EXPECT_LT((pose.rotation - R).norm(), 1e-14);
    EXPECT_LT((pose.translation - R * translation).norm(), 1e-12);
    Vector6d wanted;
    wanted << angles, translation;
    EXPECT_LT((diffDrrParameters(pose) - wanted).norm(), 1e-12);
}

}   // namespace
