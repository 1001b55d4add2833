#pragma once

#include "core/registration/pnp/kernel_pnp.h"

namespace angiopose::core {

/// Problems of the alternating search (ALGORITHMS §3.2): rotation about the source, auxiliary points with fixed
/// matches, all points with updated matches.
enum class SearchStage { Turn, Auxiliary, Full };

/// Interface of point-matching methods for the alternating search. A pose is a motion of the points in their own frame.
class PointSolver {
public:
    virtual ~PointSolver() = default;

    /// Solves one problem from `start`, reports every step to `observe`, and returns immediately on a stop request.
    virtual KernelPnpResult solve(const KernelProblem& problem, SearchStage stage, const RigidTransform& start,
                                  const KernelObserver& observe) = 0;

    /// Returns the maximum number of steps of `solve`.
    virtual int maxIterations(SearchStage stage) const = 0;

    /// Whether the solver can solve for the rotation alone.
    virtual bool canSolveRotation() const { return true; }
};

}   // namespace angiopose::core
