#pragma once

#include "core/registration/pnp/kernel_pnp.h"

namespace angiopose::core {

/// Problems of the alternating search (ALGORITHMS §3.2): rotation about the source, auxiliary points with fixed
/// partners, all points with updated partners.
enum class SearchStage { Turn, Auxiliary, Full };

/// Interface of methods that fit points to matched points, for the alternating search. Poses are motions of the points'
/// own frame.
class PointSolver {
public:
    virtual ~PointSolver() = default;

    /// Solves one problem from `start`, reports every step to `observe`, and returns immediately on a stop request.
    virtual KernelPnpResult solve(const KernelProblem& problem, SearchStage stage, const RigidTransform& start,
                                  const KernelObserver& observe) = 0;

    /// Maximum number of steps of `solve`.
    virtual int maxIterations(SearchStage stage) const = 0;

    /// Whether the solver can change the rotation alone.
    virtual bool canTurn() const { return true; }
};

}   // namespace angiopose::core