#include "core/registration/methods/methods.h"

#include "core/registration/methods/pose_trials.h"
#include "core/registration/pnp/oriented_mixture.h"
#include "core/registration/pose/minimize.h"
#include "core/registration/pose/pose_parameters.h"
#include "core/support/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr int levels = 3;
constexpr int evaluationsPerLevel = 300;
constexpr double settledMixtureMm = 1e-5;
constexpr double settledMixtureShare = 1e-9;

}   // namespace

MethodSolution solveOgmm(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress)
{
    Stopwatch stopwatch;
    PoseTrials search(problem, levels * evaluationsPerLevel, progress);
    MixtureOptions mixtureOptions{std::max(options.ogmm.startScalePx, options.ogmm.finalScalePx),
                                  options.ogmm.orientation, options.ogmm.selfWeight};
    const double ratio = std::pow(options.ogmm.finalScalePx / mixtureOptions.scalePx, 1.0 / (levels - 1));
    MinimizeOptions lbfgs;
    lbfgs.minimizer = Minimizer::Lbfgs;
    lbfgs.tolerance = settledMixtureMm;
    lbfgs.relativeTolerance = settledMixtureShare;
    lbfgs.maxEvaluations = evaluationsPerLevel;
    bool isConverged = true;
    for (int level = 0; level < levels && !search.isStopped(); ++level) {
        OrientedMixtureMetric mixture(problem, mixtureOptions);
        search.startStage("mixtures", mixtureOptions.scalePx, std::numeric_limits<double>::infinity());
        const PoseParameters parameters(search.best(), metricUnits(problem.tree.spreadMm), problem.freedom);
        const auto cost = [&](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
            const CentroidPose pose = parameters.pose(x);
            Vector6d stepGradient;
            const double distance = mixture.distance(pose, stepGradient);
            gradient = parameters.gradient(x, stepGradient);
            return search.recordTrial(pose, distance);
        };
        isConverged = minimize(cost, parameters.origin(), lbfgs, [&] { return search.isStopped(); }).isConverged;
        mixtureOptions.scalePx *= ratio;
    }
    MethodSolution solution = search.solution(isConverged ? StopReason::Converged : StopReason::IterationLimit);
    solution.time.solveMs = stopwatch.takeLapMs();
    return solution;
}

}   // namespace angiopose::core
