#pragma once

#include "core/registration/methods/pose_trials.h"

#include <span>

namespace angiopose::core {

/// Runs kernel PnP (ALGORITHMS §3.1) with all points to convergence from each pose; keeps the pose with the lowest loss
/// at the final scale, also considering the current pose of `search`.
void refineByKernel(const RegistrationProblem& problem, std::span<const CentroidPose> poses, double finalScalePx,
                    PoseTrials& search);

inline constexpr int kernelFinishIterations = 30;   ///< maximum number of iterations per pose

}   // namespace angiopose::core
