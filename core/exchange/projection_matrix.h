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

}   // namespace angiopose::core
