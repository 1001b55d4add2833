#include "core/exchange/diffdrr_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

/// Returns the rotation that converts between RAS and LPS, in either direction.
Eigen::Matrix3d rasFromLps()
{
    return Eigen::Vector3d(-1.0, -1.0, 1.0).asDiagonal();
}

/// Returns the rotation from DiffDRR's camera axes, after its orientation, to ours: y points down instead of up, and x
/// is chosen to keep the determinant positive. DiffDRR's PA orientation is itself a reflection.
Eigen::Matrix3d oursFromDiffDrr(DiffDrrOrientation orientation)
{
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    if (orientation != DiffDrrOrientation::None) {
        const double sign = orientation == DiffDrrOrientation::Pa ? 1.0 : -1.0;
        turn << 1.0, 0.0, 0.0, 0.0, 0.0, sign, 0.0, 1.0, 0.0;
    }
    const double right = orientation == DiffDrrOrientation::Pa ? 1.0 : -1.0;
    return Eigen::Vector3d(right, -1.0, 1.0).asDiagonal() * turn.transpose();
}

/// Returns the sign of fx in our camera.
double mirrorSign(const DiffDrrDetector& detector)
{
    const bool isFromBack = detector.orientation == DiffDrrOrientation::Pa;
    return isFromBack == detector.isXReversed ? -1.0 : 1.0;
}

double centerPixel(int pixels)
{
    return 0.5 * (pixels - 1);
}

Eigen::Matrix3d rotationAbout(char axis, double angle)
{
    const Eigen::Vector3d direction = axis == 'X'   ? Eigen::Vector3d::UnitX()
                                      : axis == 'Y' ? Eigen::Vector3d::UnitY()
                                                    : Eigen::Vector3d::UnitZ();
    return Eigen::AngleAxisd(angle, direction).toRotationMatrix();
}

}   // namespace

PosedCamera posedCameraFromDiffDrr(const DiffDrrView& view)
{
    const DiffDrrDetector& detector = view.detector;
    PosedCamera posedCamera;
    posedCamera.camera = {
        mirrorSign(detector) * detector.sddMm / detector.delxMm,
        detector.sddMm / detector.delyMm,
        centerPixel(detector.width) + (detector.isXReversed ? 1.0 : -1.0) * detector.x0Mm / detector.delxMm,
        centerPixel(detector.height) + detector.y0Mm / detector.delyMm,
        detector.width,
        detector.height};
    const Eigen::Matrix3d fromWorld = oursFromDiffDrr(detector.orientation) * view.pose.rotation.transpose();
    posedCamera.cameraFromPatient.rotation = fromWorld * rasFromLps();
    posedCamera.cameraFromPatient.translation =
        -(fromWorld * (rasFromLps() * view.volumeCenterInPatient + view.pose.translation));
    return posedCamera;
}

DiffDrrView diffDrrView(const PosedCamera& posedCamera, double sddMm, const Eigen::Vector3d& volumeCenterInPatient)
{
    const ProjectionCamera& camera = posedCamera.camera;
    DiffDrrView view;
    view.volumeCenterInPatient = volumeCenterInPatient;
    DiffDrrDetector& detector = view.detector;
    detector.sddMm = sddMm;
    detector.width = camera.width;
    detector.height = camera.height;
    detector.delxMm = sddMm / std::abs(camera.fx);
    detector.delyMm = sddMm / camera.fy;
    detector.x0Mm = (camera.cx - centerPixel(camera.width)) * detector.delxMm;
    detector.y0Mm = (camera.cy - centerPixel(camera.height)) * detector.delyMm;
    detector.orientation = camera.fx < 0.0 ? DiffDrrOrientation::Pa : DiffDrrOrientation::Ap;
    const Eigen::Matrix3d turn = oursFromDiffDrr(detector.orientation);
    view.pose.rotation = rasFromLps() * posedCamera.cameraFromPatient.rotation.transpose() * turn;
    view.pose.translation = -(rasFromLps() * volumeCenterInPatient) -
                            view.pose.rotation * (turn.transpose() * posedCamera.cameraFromPatient.translation);
    return view;
}

RigidTransform diffDrrPose(std::string_view axes, const Eigen::Vector3d& angles, const Eigen::Vector3d& translationMm)
{
    RigidTransform pose;
    for (int i = 0; i < 3; ++i) {
        pose.rotation = pose.rotation * rotationAbout(axes[static_cast<std::size_t>(i)], angles(i));
    }
    pose.translation = pose.rotation * translationMm;
    return pose;
}

/// Uses that, for Rz(a) Rx(b) Ry(c), the last row is (-cos b sin c, sin b, cos b cos c) and the second column starts
/// with (-sin a cos b, cos a cos b).
Vector6d diffDrrParameters(const RigidTransform& pose)
{
    const Eigen::Matrix3d& R = pose.rotation;
    Vector6d parameters;
    parameters << std::atan2(-R(0, 1), R(1, 1)), std::asin(std::clamp(R(2, 1), -1.0, 1.0)),
        std::atan2(-R(2, 0), R(2, 2)), R.transpose() * pose.translation;
    return parameters;
}

}   // namespace angiopose::core
