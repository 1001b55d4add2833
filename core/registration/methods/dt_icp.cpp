#include "core/registration/methods/dt_icp.h"

#include "core/registration/pnp/alternating_search.h"
#include "core/registration/pnp/distance_descent.h"
#include "core/support/stopwatch.h"

#include <cmath>

namespace angiopose::core {

MethodSolution solveDtIcp(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress)
{
    Stopwatch stopwatch;
    const SeedProblem seed = makeSeedProblem(problem, options);
    const double targetMs = stopwatch.lapMs();
    DistanceDescent solver({static_cast<DescentSolver>(std::lround(options.icpSolver)), options.huberPx,
                            options.icpIterations, options.icpModel != 0.0});
    const bool alternates = options.alternate != 0.0;
    const Alternation alternation{alternates && options.rotationFirst != 0.0, alternates};
    MethodSolution solution = searchAlternating(problem, options, seed, solver, alternation, progress);
    solution.time.targetMs = targetMs;
    return solution;
}

}   // namespace angiopose::core