#pragma once

#include "core/registration/centroid_pose.h"
#include "core/registration/registration_problem.h"
#include "core/registration/target_lines.h"

namespace core {

/// What the residuals at a pose tell about the noise.
struct ResidualNoise {
    double stdPx = 0.0;   ///< robust, of distances across the vessels
    double correlationPoints = 1.0;   ///< neighbouring tree points that share one error (l_c)
    int pointCount = 0;   ///< tree points that agree with the target
};

/// Covariance of the pose from the residuals, their correlation along the branches, and the start pose's prior
/// (ALGORITHMS §6.10). A degree of freedom is observed when the image alone beats half the prior's spread.
PoseUncertainty poseUncertainty(const RegistrationProblem& problem, const TargetLines& target,
                                const RigidTransform& cameraFromPatient, const StartPrior& prior);

/// Noise of the tree points that lie along the target.
ResidualNoise residualNoise(const TreeSamples& tree, const std::vector<double>& residualsPx);

}   // namespace core
