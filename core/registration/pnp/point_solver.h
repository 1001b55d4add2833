#pragma once

#include "core/registration/pnp/kernel_pnp.h"

namespace angiopose::core {

/// The problems of the alternating search (ALGORITHMS §3.2): turning about the source, the auxiliary points with held
/// partners, all points with fresh ones.
enum class SearchStage { Turn, Auxiliary, Full };

/// A method that lays points onto matched points, as the alternating search drives it. Poses are motions of the points'
/// own frame.
class PointSolver {
public:
    virtual ~PointSolver() = default;

    /// Solves one problem from `start`, telling `observe` of every step, and returns at once when told to stop.
    virtual KernelPnpResult solve(const KernelProblem& problem, SearchStage stage, const RigidTransform& start,
                                  const KernelObserver& observe) = 0;

    /// Steps that `solve` takes at most.
    virtual int maxIterations(SearchStage stage) const = 0;

    /// Whether it can move the rotation alone.
    virtual bool canTurn() const { return true; }
};

}   // namespace angiopose::core