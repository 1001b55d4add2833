#pragma once

#include "core/registration/pnp/kernel_distances.h"
#include "core/registration/pnp/scale_annealing.h"
#include "core/registration/pose/pose_prior.h"
#include "core/registration/problem/registration_result.h"

#include <functional>
#include <limits>

namespace angiopose::core {

/// Schedule of kernel PnP (ALGORITHMS §3.1).
struct KernelSchedule {
    int maxIterations = 60;   ///< maximum number of accepted steps
    double finalScalePx = 1.0;   ///< final ℓ
    StartScale startScale = StartScale::Largest;
    Decay decay = Decay::Halving;
    Freedom freedom = Freedom::Full;
    double minDepthMm = 0.0;   ///< minimum distance of the points' centroid from the source
    double maxDepthMm =
        std::numeric_limits<double>::infinity();   ///< maximum distance of the points' centroid from the source
};

/// Report of one accepted step.
struct KernelIteration {
    int iteration = 0;   ///< number of the step, starting at 1
    double scalePx = 0.0;
    RigidTransform pose;
    const KernelDistances* distances = nullptr;   ///< distances at `pose`
};

using KernelObserver = std::function<ObserverDecision(const KernelIteration&)>;

struct KernelPnpResult {
    RigidTransform pose;
    StopReason stopReason = StopReason::IterationLimit;
    int iterations = 0;
    double scalePx = 0.0;   ///< ℓ of the last step
};

/// DynaWeightPnP* (ALGORITHMS §3.1): maximizes E_data = Σ exp(−d²/2ℓ²) together with `prior` by reweighted least
/// squares while annealing ℓ from the largest distance. No accepted step lowers E_data at the current ℓ.
class KernelPnp {
public:
    KernelPnp(const KernelProblem& problem, const PosePrior& prior, const KernelSchedule& schedule)
        : problem_(problem), prior_(prior), schedule_(schedule)
    {
    }

    KernelPnpResult solve(const RigidTransform& start, const KernelObserver& observe = {});

private:
    KernelProblem problem_;
    PosePrior prior_;
    KernelSchedule schedule_;
};

}   // namespace angiopose::core
