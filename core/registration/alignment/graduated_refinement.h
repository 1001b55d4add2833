#pragma once

#include "core/registration/alignment/alignment.h"
#include "core/registration/problem/registration_result.h"

#include <functional>

namespace angiopose::core {

/// Schedule of one refinement (ALGORITHMS §6.5).
struct RefinementSchedule {
    double startScalePx = 14.0;
    double endScalePx = 0.7;   ///< the residual noise may end the refinement earlier
    double shrink = 0.7;
    int stepsPerScale = 2;
    int lastSteps = 0;   ///< extra steps at the final scale, until they no longer move the projection
    int maxSteps = 60;
    bool bothWays = false;   ///< also match target lines to the tree (§6.6 b)
};

struct RefinementStep {
    const CentroidPose& pose;
    double scalePx;
    double progress;   ///< 0…1
};
using RefinementObserver = std::function<Verdict(const RefinementStep&)>;

struct RefinementResult {
    CentroidPose pose;
    double scalePx = 0.0;   ///< final ℓ
    int steps = 0;
    StopReason stopReason = StopReason::Converged;
};

/// Graduated non-convexity: damped Gauss–Newton on the Welsch loss while its scale shrinks. Rejects a step that raises
/// the loss at its scale by more than the jitter of the matches.
RefinementResult refine(Alignment& alignment, const StartPrior& prior, const CentroidPose& start,
                        const RefinementSchedule& schedule, const RefinementObserver& observe = {});

}   // namespace angiopose::core