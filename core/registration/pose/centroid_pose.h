#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/registration/pose/damped_step.h"

namespace angiopose::core {

/// Pose relative to the tree's centroid (OBJ parameters, ALGORITHMS §1), for which a rotation does not shift the image.
/// pointInCamera = rotation (pointInPatient − centroidInPatient) + centroidInCamera.
struct CentroidPose {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d centroidInCamera = Eigen::Vector3d::Zero();
};

CentroidPose aboutCentroid(const RigidTransform& cameraFromPatient, const Eigen::Vector3d& centroidInPatient);
RigidTransform cameraFromPatient(const CentroidPose& pose, const Eigen::Vector3d& centroidInPatient);

/// Returns the pose after a step (rotation vector rad, shift mm) in camera axes.
CentroidPose retract(const CentroidPose& pose, const Vector6d& step);

/// Returns the step from one pose to the other; inverse of `retract`.
Vector6d stepBetween(const CentroidPose& from, const CentroidPose& to);

/// Returns the largest motion that a step causes for points at a distance of `spreadMm` from the centroid.
double stepLengthMm(const Vector6d& step, double spreadMm);

}   // namespace angiopose::core
