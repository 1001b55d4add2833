#pragma once

#include "core/registration/pnp/point_solver.h"

namespace angiopose::core {

struct DescentOptions {
    DescentSolver solver = DescentSolver::DampedSteps;
    double huberPx = 5.0;
    int maxIterations = 100;
    bool hasAffineStage = false;
};

/// Minimizes the distances to the nearest target points (ALGORITHMS §3.6). Nothing prevents the tree from shrinking
/// onto part of the target; this is a property of the published method.
class DistanceDescent final : public PointSolver {
public:
    explicit DistanceDescent(const DescentOptions& options) : options_(options) {}

    KernelPnpResult solve(const KernelProblem& problem, SearchStage stage, const RigidTransform& start,
                          const KernelObserver& observe) override;
    int maxIterations(SearchStage) const override;

private:
    KernelPnpResult descend(const KernelProblem& problem, Freedom freedom, const RigidTransform& start,
                            const KernelObserver& observe) const;
    KernelPnpResult descendSmoothly(const KernelProblem& problem, const RigidTransform& start,
                                    const KernelObserver& observe) const;
    void tryAffine(const KernelProblem& problem, const KernelObserver& observe, KernelPnpResult& result) const;

    DescentOptions options_;
};

}   // namespace angiopose::core
