#include "core/registration/methods/methods.h"

#include "core/registration/methods/pose_trials.h"
#include "core/registration/picture/vessel_brightness.h"
#include "core/registration/pose/evolution.h"
#include "core/registration/pose/pose_parameters.h"
#include "core/support/stopwatch.h"

#include <limits>

namespace angiopose::core {

MethodSolution solveEvolution(const RegistrationProblem& problem, const RegistrationOptions& options,
                              ProgressLog& progress)
{
    Stopwatch stopwatch;
    const VesselBrightness brightness(problem);
    const double targetMs = stopwatch.takeLapMs();

    PoseTrials search(problem, options.evolution.evaluations, progress);
    search.startStage("evolution", 0.0, std::numeric_limits<double>::infinity());
    const PoseParameters parameters(search.start(), clinicalUnits(3.0, 3.0, 10.0, 20.0), problem.freedom);
    const auto cost = [&](const Eigen::VectorXd& x) {
        const CentroidPose pose = parameters.pose(x);
        return search.recordTrial(pose, -brightness.meanAt(pose, 1.0));
    };
    const EvolutionSettings evolution{options.evolution.population, options.evolution.evaluations, 1e-3,
                                      static_cast<std::uint64_t>(options.randomSeed)};
    const auto isStopped = [&] { return search.isStopped(); };
    const auto evolve =
        options.evolution.strategy == EvolutionStrategy::OnePlusOne ? minimizeOnePlusOneEs : minimizeCmaEs;
    const bool isConverged = evolve(cost, parameters.count(), evolution, isStopped);

    MethodSolution solution = search.solution(isConverged ? StopReason::Converged : StopReason::IterationLimit);
    solution.time.targetMs = targetMs;
    solution.time.solveMs = stopwatch.takeLapMs();
    return solution;
}

}   // namespace angiopose::core
