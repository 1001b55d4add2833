#pragma once

#include "core/registration/matching/target_lines.h"
#include "core/registration/pose/initial_pose_prior.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Information that one view provides about a pose and about its camera.
struct UncertaintyEstimate {
    PoseUncertainty uncertainty;
    std::optional<CameraEvidence> camera;   ///< nullopt if the camera is treated as exact
};

/// Estimates the pose covariance from the residuals across the vessels, their correlation along the branches, the prior
/// of the initial pose (ALGORITHMS §6.10), and the camera errors (§6.18). A degree of freedom counts as observed if the
/// image alone gives less than half the standard deviation of the prior.
UncertaintyEstimate estimateUncertainty(const RegistrationProblem& problem, const TargetLines& target,
                                        const RigidTransform& cameraFromPatient, const InitialPosePrior& prior);

/// Returns the pose uncertainty from the image information and the covariance caused by camera errors, both for steps
/// (rad, mm) about the centroid of the used points in camera axes. Locked degrees of freedom are exact.
PoseUncertainty poseUncertainty(const RegistrationProblem& problem, const Matrix6d& imageInformation,
                                const Matrix6d& cameraCovariance, const InitialPosePrior& prior,
                                const CentroidPose& pose);

/// Replaces the image part of the covariance (about the centroid of the whole tree) and keeps the camera part.
/// `spreadMm` is the RMS spread of the tree.
void replaceImageCovariance(PoseUncertainty& uncertainty, const Matrix6d& covariance, double spreadMm);

/// Standard deviations for display.
struct PoseSigmas {
    Eigen::Vector3d rotationDeg = Eigen::Vector3d::Zero();   ///< 1-σ about camera x, y and z
    double inPlaneMm = 0.0;   ///< 1-σ in the less certain in-plane direction
    double depthMm = 0.0;   ///< 1-σ along the ray
};
PoseSigmas sigmasOf(const Matrix6d& covariance);

/// Returns the inverse covariance of a pose without locks, about the centroid of the used points.
Matrix6d poseInformation(const RegistrationProblem& problem, const TargetLines& target, const CentroidPose& pose,
                         const InitialPosePrior& prior);

}   // namespace angiopose::core
