#pragma once

#include "core/geometry/sight.h"
#include "core/support/result.h"

namespace angiopose::core {

using ProjectionMatrix = Eigen::Matrix<double, 3, 4>;

/// K of the camera: fx 0 cx, 0 fy cy, 0 0 1.
Eigen::Matrix3d intrinsicMatrix(const ProjectionCamera& camera);

/// P = K [R t]: `P * (pointInPatient, 1)` is the pixel times the depth in mm, then that depth.
ProjectionMatrix projectionMatrix(const Sight& sight);

/// Camera and pose of a P that is known up to a positive factor: what it sees has a positive third coordinate. Then
/// det R = +1 and fy > 0 leave one solution; the sign of fx tells whether the image is mirrored (FORMATS §1). The image
/// size is not known: 0. Fails on a skew and on what is no camera.
Result<Sight> sightFromProjection(const ProjectionMatrix& projection);

/// The same of K, R and t; exact values stay to the last bit. A mirror in R goes into fx, a negative fy turns the
/// camera half round its axis; an R that is rounded (by up to 1e-3) becomes the nearest rotation.
Result<Sight> sightFromIntrinsics(const Eigen::Matrix3d& intrinsic, const Eigen::Matrix3d& rotation,
                                  const Eigen::Vector3d& translation);

/// Where the camera's frame of xReg lies: its origin in the source with the detector at negative z (of X-ray runs of
/// C-arms) or at positive z, or its origin on the detector with z to the source.
enum class XregFrame { DetectorAtNegativeZ, DetectorAtPositiveZ, OriginOnDetector };

/// A camera as xReg has it: `pixel ~ intrinsic * (cameraFromWorld * pointInWorld)`, of a frame on the detector with
/// f - z for z. x runs along the columns and y along the rows; (0, 0) is the centre of the first pixel.
struct XregCamera {
    Eigen::Matrix3d intrinsic = Eigen::Matrix3d::Identity();
    RigidTransform cameraFromWorld;
    XregFrame frame = XregFrame::DetectorAtNegativeZ;
    int columns = 0;
    int rows = 0;
    double columnSpacingMm = 1.0;
    double rowSpacingMm = 1.0;
};

/// Our camera and pose. `volumeFromWorld` is what xReg keeps as a pose ("camera to volume"): it takes points of the
/// world that `cameraFromWorld` starts from to physical points of the volume, which are LPS mm as ITK reads them.
Result<Sight> sightFromXreg(const XregCamera& camera, const RigidTransform& volumeFromWorld);

/// The pose that xReg keeps of ours, beside a camera of its own.
Result<RigidTransform> xregPose(const RigidTransform& cameraFromPatient, const XregCamera& camera);

/// Our camera as one of xReg whose world is its own frame: the detector at negative z where the image is as seen from
/// the detector (fx < 0), at positive z where it is mirrored.
XregCamera xregCamera(const ProjectionCamera& camera, double sourceToDetectorMm);

}   // namespace angiopose::core
