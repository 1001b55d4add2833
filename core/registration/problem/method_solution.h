#pragma once

#include "core/registration/problem/registration_result.h"

#include <memory>

namespace angiopose::core {

class TargetLines;
struct WireFinding;

/// What a method hands back; registerVessels judges the pose.
struct MethodSolution {
    RigidTransform cameraFromPatient;   ///< the best pose found, also after a stop
    StopReason stopReason = StopReason::IterationLimit;
    int iterations = 0;
    std::vector<Hypothesis> alternatives;   ///< best first, without the solution; empty when the method seeks none
    Messages warnings;   ///< what only the method can know
    StageTimes time;   ///< totalMs stays 0
    std::shared_ptr<const TargetLines> targetLines;   ///< if the method built them, for judging
    std::optional<double> agreement;   ///< of the pose, see AgreementScore; if the method found it, for judging
    std::vector<std::uint8_t> isOpacified;   ///< 1 for each tree point that the image shows; empty: all, as far as told
    int filledForks = 0;   ///< of them, places where three filled pieces or more meet
    std::shared_ptr<const WireFinding> wire;   ///< of the method that follows a wire
    bool isSettled = false;   ///< refined by the residuals that judge it: it cannot slide to a better place close by
    bool wantsCare = false;   ///< registerVessels may hold a depth that the image does not tell, and doubt the frame
};

}   // namespace angiopose::core
