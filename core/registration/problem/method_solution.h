#pragma once

#include "core/registration/problem/registration_result.h"

#include <memory>

namespace angiopose::core {

class TargetLines;
struct WireResult;

/// Result of a method, to be assessed by registerVessels.
struct MethodSolution {
    RigidTransform cameraFromPatient;   ///< best pose found, even if stopped
    StopReason stopReason = StopReason::IterationLimit;
    int iterations = 0;
    std::vector<Hypothesis> alternatives;   ///< best first, without the solution; empty if the method provides none
    Messages warnings;   ///< messages that only the method can provide
    StageTimes time;   ///< wall times; totalMs is set by registerVessels
    std::shared_ptr<const TargetLines> targetLines;   ///< if built by the method, for reuse in the assessment
    std::optional<double>
        agreement;   ///< AgreementScore of the pose, if the method computed it, for reuse in the assessment
    std::vector<std::uint8_t>
        isOpacified;   ///< 1 for each opacified tree point; empty if the whole tree is assumed to be opacified
    int opacifiedBifurcations = 0;   ///< number of bifurcations where three or more opacified segments meet
    std::shared_ptr<const WireResult> wire;   ///< result of the wire method
    bool isFullyRefined =
        false;   ///< refined with the residuals used for its assessment, so that refining it again does not move it
    bool needsChecks = false;   ///< registerVessels may constrain a depth that the image does not determine, and check
                                ///< the image orientation
};

}   // namespace angiopose::core
