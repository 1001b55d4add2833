#include "core/registration/methods/nicp.h"

#include "core/registration/alternating_search.h"
#include "core/registration/kernel_ascent.h"
#include "core/support/stopwatch.h"

#include <cmath>

namespace core {
namespace {

AscentOptions ascentOptions(const RegistrationOptions& options, const SeedProblem& seed)
{
    AscentOptions ascent;
    ascent.startScalePx = std::max(options.nicpStartScalePx, options.nicpFinalScalePx);
    ascent.finalScalePx = options.nicpFinalScalePx;
    ascent.iterationsPerScale = options.nicpIterations;
    ascent.metric = static_cast<StepMetric>(std::lround(options.nicpStep));
    if (options.nicpPrior != 0.0) {
        ascent.prior = seed.prior;
    }
    return ascent;
}

MethodSolution climb(const RegistrationProblem& problem, const RegistrationOptions& options, Alternation alternation,
                     ProgressLog& progress)
{
    Stopwatch stopwatch;
    const SeedProblem seed = makeSeedProblem(problem, options);
    const double targetMs = stopwatch.lapMs();
    KernelAscent solver(ascentOptions(options, seed), (problem.start * problem.tree.centroid).z());
    MethodSolution solution = searchAlternating(problem, options, seed, solver, alternation, progress);
    solution.time.targetMs = targetMs;
    return solution;
}

}   // namespace

MethodSolution solveNicp(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress)
{
    return climb(problem, options, {}, progress);
}

MethodSolution solveNicpAlternating(const RegistrationProblem& problem, const RegistrationOptions& options,
                                    ProgressLog& progress)
{
    return climb(problem, options, {options.rotationFirst != 0.0, true}, progress);
}

}   // namespace core
