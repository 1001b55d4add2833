#pragma once

#include "core/registration/problem/registration_result.h"

#include <memory>

namespace angiopose::core {

class TargetLines;
struct WireFinding;

/// Result of a method; registerVessels judges the pose.
struct MethodSolution {
    RigidTransform cameraFromPatient;   ///< best pose found, also after a stop
    StopReason stopReason = StopReason::IterationLimit;
    int iterations = 0;
    std::vector<Hypothesis> alternatives;   ///< best first, without the solution; empty if the method has none
    Messages warnings;   ///< messages that only the method can provide
    StageTimes time;   ///< totalMs stays 0
    std::shared_ptr<const TargetLines> targetLines;   ///< if built by the method, for reuse in the assessment
    std::optional<double>
        agreement;   ///< of the pose, see AgreementScore; if computed by the method, for reuse in the assessment
    std::vector<std::uint8_t>
        isOpacified;   ///< 1 for each tree point visible in the image; empty: all, as far as known
    int filledForks = 0;   ///< number of places where three or more opacified pieces meet
    std::shared_ptr<const WireFinding> wire;   ///< result of the wire method
    bool isSettled =
        false;   ///< already refined by the residuals that judge it: it cannot slide to a better pose nearby
    bool wantsCare = false;   ///< registerVessels may constrain a depth that the image does not determine, and check
                              ///< the image orientation
};

}   // namespace angiopose::core
