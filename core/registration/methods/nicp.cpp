#include "core/registration/methods/methods.h"

#include "core/registration/methods/pose_trials.h"
#include "core/registration/picture/vessel_brightness.h"
#include "core/registration/pnp/alternating_search.h"
#include "core/registration/pnp/kernel_ascent.h"
#include "core/support/stopwatch.h"

#include <cmath>

namespace angiopose::core {
namespace {

AscentOptions ascentOptions(const RegistrationOptions& options, const SeedProblem& seed)
{
    AscentOptions ascent;
    ascent.startScalePx = std::max(options.nicp.startScalePx, options.nicp.finalScalePx);
    ascent.finalScalePx = options.nicp.finalScalePx;
    ascent.iterationsPerScale = options.nicp.iterations;
    ascent.metric = options.nicp.step;
    if (options.nicp.prior) {
        ascent.prior = seed.prior;
    }
    return ascent;
}

MethodSolution climb(const RegistrationProblem& problem, const RegistrationOptions& options, Alternation alternation,
                     ProgressLog& progress)
{
    Stopwatch stopwatch;
    const SeedProblem seed = makeSeedProblem(problem, options);
    const double targetMs = stopwatch.takeLapMs();
    KernelAscent solver(ascentOptions(options, seed), (problem.start * problem.tree.centroid).z());
    MethodSolution solution = searchAlternating(problem, options, seed, solver, alternation, progress);
    solution.time.targetMs = targetMs;
    return solution;
}

constexpr double widthScales[] = {2.0, 1.0};   // blur factors; the wider initial blur has a larger capture range
constexpr double firstMotionPx = 2.0;
constexpr double settledBrightnessPx = 0.01;

double meanMotionPx(const RegistrationProblem& problem, const CentroidPose& pose, const Vector6d& step)
{
    const double depthMm = std::max(minProjectableDepthMm, pose.centroidInCamera.z());
    const double motionMm = step.tail<3>().norm() + problem.tree.spreadMm * step.head<3>().norm();
    return motionMm / millimetersPerPixel(problem.camera, depthMm);
}

/// Descends along the gradient until the steps become negligible; returns whether they did.
bool settle(const RegistrationProblem& problem, const VesselBrightness& brightness, double widthScale, int iterations,
            PoseTrials& search)
{
    double motionPx = firstMotionPx * widthScale;
    for (int i = 0; i < iterations && !search.isStopped(); ++i) {
        const CentroidPose pose = search.best();
        const double before = search.bestCost();
        const Vector6d direction = problem.freedom.dampedStep(brightness.normalEquations(pose, widthScale), 1e-3, pose);
        const double unitPx = meanMotionPx(problem, pose, direction);
        if (!(unitPx > 0.0)) {
            return true;
        }
        motionPx *= 2.0;
        do {
            motionPx *= 0.5;
            const CentroidPose next = problem.freedom.retract(pose, motionPx / unitPx * direction);
            search.recordTrial(next, -brightness.meanAt(next, widthScale));
        } while (!(search.bestCost() < before) && motionPx > settledBrightnessPx && !search.isStopped());
        if (!(search.bestCost() < before)) {
            return true;
        }
        motionPx *= 2.0;
    }
    return false;
}

MethodSolution climbBrightness(const RegistrationProblem& problem, const RegistrationOptions& options,
                               ProgressLog& progress)
{
    Stopwatch stopwatch;
    const VesselBrightness brightness(problem);
    const double targetMs = stopwatch.takeLapMs();
    PoseTrials search(problem, 2 * options.nicp.iterations, progress);
    bool isSettled = true;
    for (const double widthScale : widthScales) {
        search.startStage("brightness", 0.0, -brightness.meanAt(search.best(), widthScale));
        isSettled = settle(problem, brightness, widthScale, options.nicp.iterations, search);
    }
    MethodSolution solution = search.solution(isSettled ? StopReason::Converged : StopReason::IterationLimit);
    solution.time.targetMs = targetMs;
    solution.time.solveMs = stopwatch.takeLapMs();
    return solution;
}

}   // namespace

MethodSolution solveNicp(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress)
{
    return options.nicp.image == NicpImage::Brightness ? climbBrightness(problem, options, progress)
                                                       : climb(problem, options, {}, progress);
}

MethodSolution solveNicpAlternating(const RegistrationProblem& problem, const RegistrationOptions& options,
                                    ProgressLog& progress)
{
    return climb(problem, options, {options.seed.rotationFirst, true}, progress);
}

}   // namespace angiopose::core
