#pragma once

#include "core/registration/pnp/point_solver.h"
#include "core/registration/pnp/seed_problem.h"
#include "core/registration/problem/method_solution.h"
#include "core/registration/problem/progress_log.h"

namespace angiopose::core {

/// Enabled parts of the alternating search; if both are disabled, it solves a single problem with all points.
struct Alternation {
    bool rotatesFirst = false;
    bool alternates = false;
};

/// Runs a point-matching method inside the alternating search of Song and Ghaffari (ALGORITHMS §3.2): auxiliary points
/// with fixed matches push the pose out of local optima of all points. Ends when the median distance is below one pixel
/// or no longer changes, after at most five rounds, with the pose that has the best E_data at the final kernel width.
MethodSolution searchAlternating(const RegistrationProblem& problem, const RegistrationOptions& options,
                                 const SeedProblem& seed, PointSolver& solver, Alternation alternation,
                                 ProgressLog& progress);

}   // namespace angiopose::core
