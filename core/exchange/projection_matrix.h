#pragma once

#include "core/geometry/posed_camera.h"
#include "core/support/result.h"

namespace angiopose::core {

using ProjectionMatrix = Eigen::Matrix<double, 3, 4>;

/// Returns the intrinsic matrix K of the camera: rows (fx 0 cx), (0 fy cy), (0 0 1).
Eigen::Matrix3d intrinsicMatrix(const ProjectionCamera& camera);

/// Returns P = K [R t]: `P * (pointInPatient, 1)` is the pixel times the depth in mm, then that depth.
ProjectionMatrix projectionMatrix(const PosedCamera& posedCamera);

/// Decomposes P, known up to a positive factor, into camera and pose; visible points have a positive third coordinate.
/// With det R = +1 and fy > 0 the solution is unique; the sign of fx shows whether the image is mirrored (FORMATS §1).
/// The image size is unknown and set to 0. Fails for skewed and for degenerate matrices.
Result<PosedCamera> posedCameraFromMatrix(const ProjectionMatrix& projection);

/// Returns the camera and pose given by K, R and t; exact values are preserved to the last bit. A reflection in R is
/// moved into fx, a negative fy rotates the camera by 180° about its axis, and a rounded R (by up to 1e-3) is replaced
/// by the nearest rotation.
Result<PosedCamera> posedCameraFromIntrinsics(const Eigen::Matrix3d& intrinsic, const Eigen::Matrix3d& rotation,
                                              const Eigen::Vector3d& translation);

/// Camera frames of xReg: the origin is at the source, with the detector at negative z (X-ray runs of C-arms) or at
/// positive z, or the origin is on the detector, with z toward the source.
enum class XregFrame { DetectorAtNegativeZ, DetectorAtPositiveZ, OriginOnDetector };

/// A camera in xReg's convention: `pixel ~ intrinsic * (cameraFromWorld * pointInWorld)`; if the frame is on the
/// detector, z is replaced by f - z. The x axis runs along the columns and y along the rows; (0, 0) is the center of
/// the first pixel.
struct XregCamera {
    Eigen::Matrix3d intrinsic = Eigen::Matrix3d::Identity();
    RigidTransform cameraFromWorld;
    XregFrame frame = XregFrame::DetectorAtNegativeZ;
    int columns = 0;
    int rows = 0;
    double columnSpacingMm = 1.0;
    double rowSpacingMm = 1.0;
};

/// Converts an xReg camera to our camera and pose. `volumeFromWorld` is the pose that xReg stores ("camera to volume"):
/// it maps points of the world of `cameraFromWorld` to physical points of the volume, which are LPS mm as read by ITK.
Result<PosedCamera> posedCameraFromXreg(const XregCamera& camera, const RigidTransform& volumeFromWorld);

/// Converts our pose to the pose that xReg stores for the given xReg camera.
Result<RigidTransform> xregPose(const RigidTransform& cameraFromPatient, const XregCamera& camera);

/// Converts our camera to an xReg camera whose world frame is the camera frame. The detector is at negative z if the
/// image is as seen from the detector (fx < 0) and at positive z if it is mirrored.
XregCamera xregCamera(const ProjectionCamera& camera, double sourceToDetectorMm);

}   // namespace angiopose::core
