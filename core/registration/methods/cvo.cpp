#include "core/registration/methods/methods.h"

#include "core/registration/methods/pose_trials.h"
#include "core/registration/pnp/kernel_flow.h"
#include "core/support/stopwatch.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace angiopose::core {
namespace {

constexpr int stepsAtFirstScale = 30;   // as in the published method
constexpr double maxFlowStep = 0.5;   // in units of ℓ; for longer steps the truncated series is inaccurate
constexpr double settledFlowPx = 1e-3;

/// Returns the ascent direction, restricted to the free steps, in a metric that counts a rotation as the shift it
/// causes at the RMS radius of the tree.
Vector6d ascentDirection(const RegistrationProblem& problem, const Vector6d& gradient, const CentroidPose& pose)
{
    const double turnMm = problem.tree.spreadMm * problem.tree.spreadMm;
    NormalEquations metric;
    metric.hessian.diagonal() << turnMm, turnMm, turnMm, 1.0, 1.0, 1.0;
    metric.gradient = -gradient;
    return problem.freedom.dampedStep(metric, 0.0, pose);
}

/// Returns the position of the first maximum of the series, at most 1.
double firstMaximum(const PowerSeries& series)
{
    constexpr int stretches = 64;
    double below = 0.0;
    for (int k = 1; k <= stretches; ++k) {
        double above = static_cast<double>(k) / stretches;
        if (series.slope(above) > 0.0) {
            below = above;
            continue;
        }
        for (int halving = 0; halving < 40; ++halving) {
            const double middle = 0.5 * (below + above);
            (series.slope(middle) > 0.0 ? below : above) = middle;
        }
        return below;
    }
    return 1.0;
}

struct FlowStep {
    Vector6d step = Vector6d::Zero();
    double motionPx = 0.0;
};

FlowStep flowStep(const RegistrationProblem& problem, const KernelFlow& flow, const Vector6d& gradient,
                  const CentroidPose& pose, double scalePx)
{
    const Vector6d direction = ascentDirection(problem, gradient, pose);
    const double lengthMm = stepLengthMm(direction, problem.tree.spreadMm);
    if (!(lengthMm > 0.0)) {
        return {};
    }
    const double depthMm = std::max(minProjectableDepthMm, pose.centroidInCamera.z());
    const double longestPx = maxFlowStep * scalePx;
    const Vector6d longest = longestPx * millimetersPerPixel(problem.camera, depthMm) / lengthMm * direction;
    const double share = firstMaximum(flow.along(longest));
    return {share * longest, share * longestPx};
}

}   // namespace

MethodSolution solveCvo(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress)
{
    Stopwatch stopwatch;
    PoseTrials search(problem, options.cvo.iterations, progress);
    StopReason reason = StopReason::IterationLimit;
    CentroidPose pose = search.start();
    FlowOptions flowOptions{std::max(options.cvo.startScalePx, options.cvo.finalScalePx), options.cvo.directions};
    std::optional<KernelFlow> flow;
    for (int k = 0; k < options.cvo.iterations && !search.isStopped(); ++k) {
        if (!flow) {
            flow.emplace(problem, flowOptions);
            search.startStage("flow", flowOptions.scalePx, std::numeric_limits<double>::infinity());
        }
        const KernelFlow::ValueAndGradient slope = flow->at(pose);
        search.recordTrial(pose, -slope.value);
        const bool isFinal = flowOptions.scalePx <= options.cvo.finalScalePx;
        const FlowStep next = flowStep(problem, *flow, slope.gradient, pose, flowOptions.scalePx);
        if (next.motionPx < settledFlowPx && (isFinal || slope.value == 0.0)) {
            reason = slope.value > 0.0 ? StopReason::Converged : StopReason::NoImprovement;
            break;
        }
        pose = problem.freedom.retract(pose, next.step);
        if (k + 1 >= stepsAtFirstScale && !isFinal) {
            flowOptions.scalePx = std::max(options.cvo.finalScalePx, options.cvo.decay * flowOptions.scalePx);
            flow.reset();
        }
    }
    MethodSolution solution = search.solution(reason);
    solution.time.solveMs = stopwatch.takeLapMs();
    return solution;
}

}   // namespace angiopose::core
