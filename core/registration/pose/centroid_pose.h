#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/registration/pose/damped_step.h"
#include "core/registration/registration_options.h"

namespace core {

/// A pose told by the tree's centroid (OBJ parameters, ALGORITHMS §1): turning does not shift the image.
/// pointInCamera = rotation (pointInPatient − centroidInPatient) + centroidInCamera.
struct CentroidPose {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d centroidInCamera = Eigen::Vector3d::Zero();
};

CentroidPose aboutCentroid(const RigidTransform& cameraFromPatient, const Eigen::Vector3d& centroidInPatient);
RigidTransform cameraFromPatient(const CentroidPose& pose, const Eigen::Vector3d& centroidInPatient);

/// The pose after a step (rotation vector rad, shift mm) in camera axes.
CentroidPose moved(const CentroidPose& pose, const Vector6d& step);

/// Step that leads from one pose to the other; inverse of moved.
Vector6d stepBetween(const CentroidPose& from, const CentroidPose& to);

/// How far the start pose may be trusted (ALGORITHMS §6.6 a): independent normal errors about the centroid.
struct StartPrior {
    CentroidPose start;
    Vector6d std = Vector6d::Ones();   ///< rad, mm

    /// Σ ((θ_k − θ_k0)/σ_k)².
    double cost(const CentroidPose& pose) const;

    /// Adds `variance` · cost for steps about `pose`.
    void add(const CentroidPose& pose, double variance, NormalEquations& equations) const;
};

StartPrior startPrior(const CentroidPose& start, const RegistrationOptions& options);

}   // namespace core
