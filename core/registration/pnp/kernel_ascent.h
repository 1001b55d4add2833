#pragma once

#include "core/registration/pnp/point_solver.h"

namespace angiopose::core {

struct AscentOptions {
    double startScalePx = 20.0;
    double finalScalePx = 3.0;
    int iterationsPerScale = 300;
    StepMetric metric = StepMetric::Balanced;
    PosePrior prior;   ///< prior, used in the full problem only
};

/// First-order ascent of Σ exp(−d²/2σ²) at three widths σ from coarse to fine, with Armijo backtracking and matches
/// updated at every evaluation (ALGORITHMS §3.3).
class KernelAscent final : public PointSolver {
public:
    KernelAscent(const AscentOptions& options, double depthMm) : options_(options), depthMm_(depthMm) {}

    KernelPnpResult solve(const KernelProblem& problem, SearchStage stage, const RigidTransform& start,
                          const KernelObserver& observe) override;
    int maxIterations(SearchStage) const override;

private:
    AscentOptions options_;
    double depthMm_;
};

}   // namespace angiopose::core
