#pragma once

#include "core/registration/methods/pose_trials.h"

#include <span>

namespace angiopose::core {

/// Runs kernel PnP (ALGORITHMS §3.1) on all points from each of the poses to its end; keeps the pose with the least
/// loss at the final scale, including the current pose of `search`.
void refineByKernel(const RegistrationProblem& problem, std::span<const CentroidPose> poses, double finalScalePx,
                    PoseTrials& search);

inline constexpr int kernelFinishIterations = 30;   ///< limit for each pose

}   // namespace angiopose::core
