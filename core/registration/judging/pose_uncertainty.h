#pragma once

#include "core/registration/matching/target_lines.h"
#include "core/registration/pose/start_prior.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// What one view tells about a pose and about the camera.
struct PoseKnowledge {
    PoseUncertainty uncertainty;
    std::optional<CameraEvidence> camera;   ///< none: the camera counts as exact
};

/// Covariance of the pose from the residuals across the vessels, what they share along the branches, the start pose's
/// prior (ALGORITHMS §6.10), and the errors of the camera (§6.18). A degree of freedom is observed when the image alone
/// beats half the prior's spread.
PoseKnowledge poseKnowledge(const RegistrationProblem& problem, const TargetLines& target,
                            const RigidTransform& cameraFromPatient, const StartPrior& prior);

/// The same from what images tell about a pose: information for steps (rad, mm) about the centroid of the used points
/// in camera axes, and the covariance of such steps by errors of the cameras. Locked degrees of freedom are certain.
PoseUncertainty poseUncertainty(const RegistrationProblem& problem, const Matrix6d& imageInformation,
                                const Matrix6d& covarianceByCameras, const StartPrior& prior, const CentroidPose& pose);

/// The covariance of the image becomes another one, about the centroid of the whole tree; what the cameras add stays.
/// `spreadMm`: of the tree.
void replaceImageCovariance(PoseUncertainty& uncertainty, const Matrix6d& covariance, double spreadMm);

/// Standard deviations that people read.
struct PoseSigmas {
    Eigen::Vector3d rotationDeg = Eigen::Vector3d::Zero();   ///< about camera x, y, z
    double inPlaneMm = 0.0;   ///< the larger lateral direction
    double depthMm = 0.0;   ///< along the ray
};
PoseSigmas sigmasOf(const Matrix6d& covariance);

/// Inverse of the covariance that a pose without locks has, about the centroid of the used points.
Matrix6d poseInformation(const RegistrationProblem& problem, const TargetLines& target, const CentroidPose& pose,
                         const StartPrior& prior);

}   // namespace angiopose::core
