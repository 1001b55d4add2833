#include "core/registration/methods/methods.h"

#include "core/registration/wire/find_wire_path.h"
#include "core/support/stopwatch.h"

namespace angiopose::core {

MethodSolution solveWire(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress)
{
    MethodSolution solution;
    Stopwatch stopwatch;
    const auto finding = std::make_shared<const WireResult>(
        findWirePath(problem, options, [&](double share, const RigidTransform& best) {
            IterationReport report;
            report.stage = "search";
            report.progress = share;
            report.cameraFromPatient = best;
            return progress.report(report);
        }));
    solution.wire = finding;
    solution.cameraFromPatient = finding->paths.empty() ? problem.start : finding->paths.front().cameraFromPatient;
    for (std::size_t i = 1; i < finding->paths.size(); ++i) {
        solution.alternatives.push_back({finding->paths[i].cameraFromPatient, finding->paths[i].probability});
    }
    solution.stopReason = progress.isStopped()     ? StopReason::StoppedByUser
                          : finding->paths.empty() ? StopReason::NoImprovement
                                                   : StopReason::Converged;
    solution.iterations = progress.iterations();
    solution.isFullyRefined = true;
    solution.time.solveMs = stopwatch.takeLapMs();
    return solution;
}

}   // namespace angiopose::core
