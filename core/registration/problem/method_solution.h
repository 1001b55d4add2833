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
    std::vector<Hypothesis> alternatives;   ///< best first, excluding the solution; empty if the method provides none
    Messages warnings;   ///< messages that only the method can provide
    StageTimes time;   ///< wall times; totalMs is set by registerVessels
    std::shared_ptr<const TargetLines> targetLines;   ///< set if built by the method, for reuse in the assessment
    std::optional<double>
        agreement;   ///< AgreementScore of the pose, for reuse in the assessment if the method computed it
    std::vector<std::uint8_t>
        isOpacified;   ///< 1 for each opacified tree point; empty if the whole tree is assumed to be opacified
    int opacifiedBifurcations = 0;   ///< number of bifurcations where three or more opacified segments meet
    std::shared_ptr<const WireResult> wire;   ///< result of the wire method
    bool isFullyRefined = false;   ///< whether refining it again with the residuals of its assessment would not move it
    bool needsChecks = false;   ///< registerVessels may constrain a depth that the image does not determine, and check
                                ///< the image orientation
};

}   // namespace angiopose::core
