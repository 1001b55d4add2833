#pragma once

#include "core/registration/pnp/kernel_distances.h"
#include "core/registration/pnp/scale_annealing.h"
#include "core/registration/pose/pose_prior.h"
#include "core/registration/problem/registration_result.h"

#include <functional>
#include <limits>

namespace angiopose::core {

/// How one kernel PnP run goes (ALGORITHMS §3.1).
struct KernelSchedule {
    int maxIterations = 60;   ///< accepted steps
    double finalScalePx = 1.0;   ///< ℓ ends here
    StartScale startScale = StartScale::Largest;
    Decay decay = Decay::Halving;
    Freedom freedom = Freedom::Full;
    double nearestMm = 0.0;   ///< the points' centroid may not come nearer to the source than this, …
    double farthestMm = std::numeric_limits<double>::infinity();   ///< … nor go farther away
};

/// An accepted step.
struct KernelIteration {
    int iteration = 0;   ///< from 1
    double scalePx = 0.0;
    RigidTransform pose;
    const KernelDistances* distances = nullptr;   ///< at `pose`
};

using KernelObserver = std::function<Verdict(const KernelIteration&)>;

struct KernelPnpResult {
    RigidTransform pose;
    StopReason stopReason = StopReason::IterationLimit;
    int iterations = 0;
    double scalePx = 0.0;   ///< ℓ of the last step
};

/// DynaWeightPnP*: maximises E_data = Σ exp(−d²/2ℓ²) under the pull of `prior` by reweighted least squares with
/// ℓ annealed from the largest distance. A step that lowers E_data at its ℓ is never taken. ALGORITHMS §3.1.
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
