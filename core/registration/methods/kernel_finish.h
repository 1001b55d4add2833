#pragma once

#include "core/registration/methods/pose_trials.h"

#include <span>

namespace angiopose::core {

/// Kernel PnP (ALGORITHMS §3.1) on all points from each of the poses, to its end; the pose of the least loss at the
/// final scale stays, that of `search` among them.
void refineByKernel(const RegistrationProblem& problem, std::span<const CentroidPose> poses, double finalScalePx,
                    PoseTrials& search);

inline constexpr int kernelFinishIterations = 30;   ///< for each pose at most

}   // namespace angiopose::core
