#include "core/registration/methods/methods.h"

#include "core/registration/pnp/seed_problem.h"
#include "core/support/stopwatch.h"

namespace angiopose::core {

MethodSolution solveIterativePnp(const RegistrationProblem& problem, const RegistrationOptions& options,
                                 ProgressLog& progress)
{
    MethodSolution solution;
    Stopwatch stopwatch;
    const SeedProblem seed = makeSeedProblem(problem, options);
    solution.time.targetMs = stopwatch.takeLapMs();

    KernelPnp solver(seed.full(problem.camera), seed.prior, seed.schedule);
    std::vector<double> scratch;
    const KernelPnpResult result = solver.solve({}, [&](const KernelIteration& step) {
        IterationReport report;
        report.stage = "refine";
        report.progress = static_cast<double>(step.iteration) / seed.schedule.maxIterations;
        report.scalePx = step.scalePx;
        report.medianDistancePx = medianDistancePx(*step.distances, scratch);
        report.cameraFromPatient = step.pose * problem.start;
        return progress.report(report);
    });

    solution.cameraFromPatient = result.pose * problem.start;
    solution.stopReason = result.stopReason;
    solution.iterations = result.iterations;
    solution.time.solveMs = stopwatch.takeLapMs();
    return solution;
}

}   // namespace angiopose::core
