#pragma once

#include "core/registration/matching/target_lines.h"
#include "core/registration/pose/start_prior.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Covariance of the pose from the residuals across the vessels, what they share along the branches, and the start
/// pose's prior (ALGORITHMS §6.10). A degree of freedom is observed when the image alone beats half the prior's spread.
PoseUncertainty poseUncertainty(const RegistrationProblem& problem, const TargetLines& target,
                                const RigidTransform& cameraFromPatient, const StartPrior& prior);

/// The same from what images tell about a pose: information for steps (rad, mm) about the centroid of the used points
/// in camera axes. Locked degrees of freedom are certain.
PoseUncertainty poseUncertainty(const RegistrationProblem& problem, const Matrix6d& imageInformation,
                                const StartPrior& prior, const CentroidPose& pose);

/// Inverse of the covariance that a pose without locks has, about the centroid of the used points.
Matrix6d poseInformation(const RegistrationProblem& problem, const TargetLines& target, const CentroidPose& pose,
                         const StartPrior& prior);

}   // namespace angiopose::core