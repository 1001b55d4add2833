#include "core/registration/methods/methods.h"

#include "core/registration/pnp/alternating_search.h"
#include "core/registration/pnp/distance_descent.h"
#include "core/support/stopwatch.h"

#include <cmath>

namespace angiopose::core {

MethodSolution solveDtIcp(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress)
{
    Stopwatch stopwatch;
    const SeedProblem seed = makeSeedProblem(problem, options);
    const double targetMs = stopwatch.takeLapMs();
    DistanceDescent solver(
        {options.icp.solver, options.icp.huberPx, options.icp.iterations, options.icp.model == IcpModel::Affine});
    const bool alternates = options.icp.alternate;
    const Alternation alternation{alternates && options.seed.rotationFirst, alternates};
    MethodSolution solution = searchAlternating(problem, options, seed, solver, alternation, progress);
    solution.time.targetMs = targetMs;
    return solution;
}

}   // namespace angiopose::core
