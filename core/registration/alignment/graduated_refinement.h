#pragma once

#include "core/registration/alignment/alignment.h"
#include "core/registration/problem/registration_result.h"

#include <functional>

namespace angiopose::core {

/// Schedule of one refinement (ALGORITHMS §6.5).
struct RefinementSchedule {
    double startScalePx = 14.0;
    double endScalePx = 0.7;   ///< lower limit; the residual noise may end the refinement at a larger scale
    double shrink = 0.7;
    int stepsPerScale = 2;
    int maxFinalSteps = 0;   ///< maximum number of additional steps at the final scale, until convergence
    int maxSteps = 60;
    bool matchBothDirections = false;   ///< whether target lines are also matched to the tree (§6.6 b)
};

struct RefinementStep {
    const CentroidPose& pose;
    double scalePx;
    double progress;   ///< 0…1
};
using RefinementObserver = std::function<ObserverDecision(const RefinementStep&)>;

struct RefinementResult {
    CentroidPose pose;
    double scalePx = 0.0;   ///< final ℓ
    int steps = 0;
    StopReason stopReason = StopReason::Converged;
};

/// Refines a pose by graduated non-convexity: damped Gauss–Newton on the Welsch loss with a shrinking scale. Steps that
/// raise the loss by more than the jitter due to switching matches are rejected.
RefinementResult refine(Alignment& alignment, const InitialPosePrior& prior, const CentroidPose& start,
                        const RefinementSchedule& schedule, const RefinementObserver& observe = {});

}   // namespace angiopose::core
