#pragma once

#include "core/registration/matching/target_lines.h"
#include "core/registration/pose/start_prior.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Information of one view about a pose and about the camera.
struct PoseKnowledge {
    PoseUncertainty uncertainty;
    std::optional<CameraEvidence> camera;   ///< none: the camera is treated as exact
};

/// Covariance of the pose from the residuals across the vessels, their correlation along the branches, the prior of the
/// initial pose (ALGORITHMS §6.10), and the camera errors (§6.18). A degree of freedom counts as observed if the image
/// alone gives less than half the standard deviation of the prior.
PoseKnowledge poseKnowledge(const RegistrationProblem& problem, const TargetLines& target,
                            const RigidTransform& cameraFromPatient, const StartPrior& prior);

/// Uncertainty from the image information about a pose: information for steps (rad, mm) about the centroid of the used
/// points in camera axes, and the covariance of such steps caused by camera errors. Locked degrees of freedom are
/// exact.
PoseUncertainty poseUncertainty(const RegistrationProblem& problem, const Matrix6d& imageInformation,
                                const Matrix6d& covarianceByCameras, const StartPrior& prior, const CentroidPose& pose);

/// Replaces the image part of the covariance, about the centroid of the whole tree; the camera part is kept. `spreadMm`
/// is that of the tree.
void replaceImageCovariance(PoseUncertainty& uncertainty, const Matrix6d& covariance, double spreadMm);

/// Standard deviations for display.
struct PoseSigmas {
    Eigen::Vector3d rotationDeg = Eigen::Vector3d::Zero();   ///< rotation about camera x, y, z
    double inPlaneMm = 0.0;   ///< larger of the two in-plane directions
    double depthMm = 0.0;   ///< along the ray
};
PoseSigmas sigmasOf(const Matrix6d& covariance);

/// Inverse of the covariance of an unlocked pose, about the centroid of the used points.
Matrix6d poseInformation(const RegistrationProblem& problem, const TargetLines& target, const CentroidPose& pose,
                         const StartPrior& prior);

}   // namespace angiopose::core
