#pragma once

#include "core/registration/alignment/alignment.h"
#include "core/registration/problem/registration_result.h"

#include <functional>

namespace angiopose::core {

/// How one refinement goes (ALGORITHMS §6.5).
struct RefinementSchedule {
    double startScalePx = 14.0;
    double endScalePx = 0.7;   ///< the noise of the residuals may end it earlier
    double shrink = 0.7;
    int stepsPerScale = 2;
    int lastSteps = 0;   ///< further steps at the end scale, until they no longer move the image
    int maxSteps = 60;
    bool bothWays = false;   ///< the target's lines are drawn to the tree, too (§6.6 b)
};

struct RefinementStep {
    const CentroidPose& pose;
    double scalePx;
    double progress;   ///< 0…1
};
using RefinementObserver = std::function<Verdict(const RefinementStep&)>;

struct RefinementResult {
    CentroidPose pose;
    double scalePx = 0.0;   ///< ℓ at the end
    int steps = 0;
    StopReason stopReason = StopReason::Converged;
};

/// Graduated non-convexity: damped Gauss–Newton on the Welsch loss while its scale shrinks. A step that raises the loss
/// at its scale by more than matches jitter is not taken.
RefinementResult refine(Alignment& alignment, const StartPrior& prior, const CentroidPose& start,
                        const RefinementSchedule& schedule, const RefinementObserver& observe = {});

}   // namespace angiopose::core