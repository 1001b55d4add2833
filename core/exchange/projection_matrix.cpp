#include "core/exchange/projection_matrix.h"

#include "core/messages/messages.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace angiopose::core {
namespace {

/// Maximum skew as a fraction of the focal length: 0.03 px at the edge of an image that extends over 0.3 focal lengths.
constexpr double skewTolerance = 1e-4;
constexpr double exactRotationTolerance = 1e-12;
constexpr double roundedRotationTolerance = 1e-3;
constexpr double intrinsicsTolerance = 1e-9;

Error skewError(double skew)
{
    return Error(messages::projectionSkewed(Quantity{skew, Quantity::significantDigits, "px"}));
}

/// Returns the same projection with fy > 0. The camera is rotated by 180° about its axis, which involves no rounding.
PosedCamera withPositiveFy(PosedCamera posedCamera)
{
    if (posedCamera.camera.fy < 0.0) {
        posedCamera.camera.fx = -posedCamera.camera.fx;
        posedCamera.camera.fy = -posedCamera.camera.fy;
        posedCamera.cameraFromPatient.rotation.topRows<2>() *= -1.0;
        posedCamera.cameraFromPatient.translation.head<2>() *= -1.0;
    }
    return posedCamera;
}

/// Moves a reflection from R into fx.
PosedCamera withoutReflection(PosedCamera posedCamera)
{
    if (posedCamera.cameraFromPatient.rotation.determinant() < 0.0) {
        posedCamera.camera.fx = -posedCamera.camera.fx;
        posedCamera.cameraFromPatient.rotation.row(0) *= -1.0;
        posedCamera.cameraFromPatient.translation.x() *= -1.0;
    }
    return posedCamera;
}

/// Returns the rotation by 180° about the y axis, which moves a detector at negative z to positive z, as in our frame.
Eigen::Matrix3d halfTurnAboutY()
{
    return Eigen::Vector3d(-1.0, 1.0, -1.0).asDiagonal();
}

/// Returns the mean of both focal lengths, each multiplied by its pixel spacing.
double focalLengthMm(const XregCamera& camera)
{
    return 0.5 * (std::abs(camera.intrinsic(0, 0)) * camera.columnSpacingMm +
                  std::abs(camera.intrinsic(1, 1)) * camera.rowSpacingMm);
}

/// Transform from xReg's frame to ours, with the intrinsic matrix in our frame.
struct FrameChange {
    RigidTransform oursFromXreg;
    Eigen::Matrix3d intrinsic;
};

FrameChange frameChange(const XregCamera& camera)
{
    FrameChange change{{}, camera.intrinsic};
    if (camera.frame == XregFrame::DetectorAtPositiveZ) {
        return change;
    }
    change.oursFromXreg.rotation = halfTurnAboutY();
    if (camera.frame == XregFrame::DetectorAtNegativeZ) {   // x / z = X / Z, y / z = -Y / Z
        change.intrinsic.col(1) *= -1.0;
    } else {   // in our frame (upper case), Z = f - z, X = -x and Y = y
        change.oursFromXreg.translation.z() = focalLengthMm(camera);
        change.intrinsic.col(0) *= -1.0;
    }
    return change;
}

Result<PosedCamera> worldCamera(const XregCamera& camera)
{
    const FrameChange change = frameChange(camera);
    const RigidTransform pose = change.oursFromXreg * camera.cameraFromWorld;
    auto posedCamera = posedCameraFromIntrinsics(change.intrinsic, pose.rotation, pose.translation);
    if (!posedCamera) {
        return posedCamera;
    }
    PosedCamera sized = posedCamera.value();
    sized.camera.width = camera.columns;
    sized.camera.height = camera.rows;
    return sized;
}

}   // namespace

Eigen::Matrix3d intrinsicMatrix(const ProjectionCamera& camera)
{
    Eigen::Matrix3d intrinsic;
    intrinsic << camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0;
    return intrinsic;
}

ProjectionMatrix projectionMatrix(const PosedCamera& posedCamera)
{
    return intrinsicMatrix(posedCamera.camera) * posedCamera.cameraFromPatient.matrix().topRows<3>();
}

/// Decomposes the left 3 × 3 (RQ), row by row from below: the last row is the viewing direction; the component of the
/// second row perpendicular to it has norm fy; the component of the first row along the second axis is the skew.
Result<PosedCamera> posedCameraFromMatrix(const ProjectionMatrix& projection)
{
    if (!projection.allFinite()) {
        return Error(messages::projectionNotFinite());
    }
    const double scale = projection.block<1, 3>(2, 0).norm();
    if (!(scale > 0.0)) {
        return Error(messages::projectionDegenerate());
    }
    const ProjectionMatrix P = projection / scale;
    const Eigen::Vector3d m1 = P.block<1, 3>(0, 0).transpose(), m2 = P.block<1, 3>(1, 0).transpose();
    const Eigen::Vector3d r3 = P.block<1, 3>(2, 0).transpose();
    PosedCamera posedCamera;
    ProjectionCamera& camera = posedCamera.camera;
    camera.cy = m2.dot(r3);
    const Eigen::Vector3d across = m2 - camera.cy * r3;
    camera.fy = across.norm();
    const Eigen::Vector3d r2 = across.normalized();
    const Eigen::Vector3d r1 = r2.cross(r3);
    camera.cx = m1.dot(r3);
    camera.fx = m1.dot(r1);
    const double skew = m1.dot(r2);
    const double minFocalPx = 1e-9 * (1.0 + m1.norm() + m2.norm());   // smallest valid focal length, px
    if (!(camera.fy > minFocalPx) || !(std::abs(camera.fx) > minFocalPx)) {
        return Error(messages::projectionDegenerate());
    }
    if (std::abs(skew) > skewTolerance * std::abs(camera.fx)) {
        return skewError(skew);
    }
    RigidTransform& pose = posedCamera.cameraFromPatient;
    pose.rotation << r1.transpose(), r2.transpose(), r3.transpose();
    pose.rotation = nearestRotation(pose.rotation);
    const Eigen::Vector3d p4 = P.col(3);
    pose.translation = {(p4.x() - camera.cx * p4.z()) / camera.fx, (p4.y() - camera.cy * p4.z()) / camera.fy, p4.z()};
    return posedCamera;
}

Result<PosedCamera> posedCameraFromIntrinsics(const Eigen::Matrix3d& intrinsic, const Eigen::Matrix3d& rotation,
                                              const Eigen::Vector3d& translation)
{
    if (!intrinsic.allFinite() || !rotation.allFinite() || !translation.allFinite()) {
        return Error(messages::projectionNotFinite());
    }
    const double scale = intrinsic(2, 2);
    if (scale == 0.0) {
        return Error(messages::projectionIntrinsics());
    }
    const Eigen::Matrix3d K = scale == 1.0 ? intrinsic : Eigen::Matrix3d(intrinsic / scale);
    const bool isUpper = std::abs(K(1, 0)) <= intrinsicsTolerance && std::abs(K(2, 0)) <= intrinsicsTolerance &&
                         std::abs(K(2, 1)) <= intrinsicsTolerance;
    if (!isUpper || K(0, 0) == 0.0 || K(1, 1) == 0.0) {
        return Error(messages::projectionIntrinsics());
    }
    if (std::abs(K(0, 1)) > skewTolerance * std::abs(K(0, 0))) {
        return skewError(K(0, 1));
    }
    PosedCamera posedCamera = withoutReflection({{K(0, 0), K(1, 1), K(0, 2), K(1, 2), 0, 0}, {rotation, translation}});
    Eigen::Matrix3d& R = posedCamera.cameraFromPatient.rotation;
    const Eigen::Matrix3d nearest = nearestRotation(R);
    const double deviation = (R - nearest).cwiseAbs().maxCoeff();
    if (!(deviation <= roundedRotationTolerance)) {
        return Error(messages::projectionNoRotation());
    }
    if (deviation > exactRotationTolerance) {
        R = nearest;
    }
    return withPositiveFy(posedCamera);
}

Result<PosedCamera> posedCameraFromXreg(const XregCamera& camera, const RigidTransform& volumeFromWorld)
{
    const auto world = worldCamera(camera);
    if (!world) {
        return world;
    }
    return PosedCamera{world.value().camera, world.value().cameraFromPatient * volumeFromWorld.inverse()};
}

Result<RigidTransform> xregPose(const RigidTransform& cameraFromPatient, const XregCamera& camera)
{
    const auto world = worldCamera(camera);
    return world ? Result<RigidTransform>(cameraFromPatient.inverse() * world.value().cameraFromPatient)
                 : world.error();
}

XregCamera xregCamera(const ProjectionCamera& camera, double sourceToDetectorMm)
{
    XregCamera xreg;
    xreg.intrinsic = intrinsicMatrix(camera);
    xreg.columns = camera.width;
    xreg.rows = camera.height;
    xreg.columnSpacingMm = sourceToDetectorMm / std::abs(camera.fx);
    xreg.rowSpacingMm = sourceToDetectorMm / std::abs(camera.fy);
    xreg.frame = camera.fx < 0.0 ? XregFrame::DetectorAtNegativeZ : XregFrame::DetectorAtPositiveZ;
    if (xreg.frame == XregFrame::DetectorAtNegativeZ) {
        xreg.intrinsic(1, 1) *= -1.0;
    }
    return xreg;
}

}   // namespace angiopose::core
