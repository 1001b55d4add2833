#include "core/registration/alignment/graduated_refinement.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double settledRefinementMm = 1e-3;   // a step this short, about 0.003 px, ends the refinement
// Tolerance per point for the jitter of the loss, which is caused by matches that switch between lines:
constexpr double jitter = 5e-3;   // times ℓ²; a smaller rise is ignored. Losing the point costs 400 times as much
constexpr double settledGainPx2 = 1e-4;   // a step with a smaller predicted gain is lost in the jitter
constexpr double maxNoiseScalePx = 5.0;   // at larger scales the noise is negligible
constexpr double madToStd = 1.4826;

/// Least-squares problem of an alignment at one scale: Welsch loss plus prior.
class AlignmentAtScale {
public:
    using State = CentroidPose;
    using Step = Vector6d;
    using Evaluation = AlignmentEvaluation;
    using Equations = NormalEquations;

    AlignmentAtScale(Alignment& alignment, const InitialPosePrior& prior, const RefinementSchedule& schedule)
        : alignment_(alignment), prior_(prior), scalePx_(schedule.startScalePx), bothWays_(schedule.matchBothDirections)
    {
    }

    bool evaluate(const CentroidPose& pose, AlignmentEvaluation& agreement) const
    {
        if (bothWays_) {
            alignment_.searchBothDirections(pose, scalePx_, agreement);
        } else {
            alignment_.evaluate(pose, scalePx_, agreement);
        }
        const double variance = noiseVariance(scalePx_);
        prior_.add(pose, variance, agreement.equations);
        agreement.loss += variance * prior_.cost(pose);
        return true;
    }

    const NormalEquations& equations(const CentroidPose&, const AlignmentEvaluation& agreement) const
    {
        return agreement.equations;
    }

    Vector6d step(const CentroidPose& pose, const NormalEquations& equations, double damping) const
    {
        return prior_.freedom.dampedStep(equations, damping, pose);
    }

    CentroidPose retract(const CentroidPose& pose, const Vector6d& step) const
    {
        return prior_.freedom.retract(pose, step);
    }

    std::optional<double> decrease(const AlignmentEvaluation& here, const AlignmentEvaluation& there) const
    {
        const double slack = jitter * scalePx_ * scalePx_ * static_cast<double>(alignment_.size());
        const double decrease = here.loss - there.loss;
        return decrease >= -slack ? std::optional(std::max(0.0, decrease)) : std::nullopt;
    }

    double lengthMm(const CentroidPose&, const Vector6d& step) const
    {
        return stepLengthMm(step, alignment_.spreadMm());
    }

    double scalePx() const { return scalePx_; }
    void setScale(double scalePx) { scalePx_ = scalePx; }

    /// Returns the robust standard deviation of the matched residuals.
    double noisePx(const CentroidPose& pose) const
    {
        std::vector<double>& residuals = alignment_.buffers().residuals;
        alignment_.collectResiduals(pose, 2.0 * scalePx_, residuals);
        std::erase_if(residuals, [](double residual) { return std::isnan(residual); });
        if (residuals.empty()) {
            return scalePx_;
        }
        const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
        std::nth_element(residuals.begin(), middle, residuals.end(),
                         [](double a, double b) { return std::abs(a) < std::abs(b); });
        return madToStd * std::abs(*middle);
    }

private:
    Alignment& alignment_;
    const InitialPosePrior& prior_;
    double scalePx_;
    bool bothWays_;
};

/// Returns the number of steps of a schedule that does not converge early.
double estimatedSteps(const RefinementSchedule& schedule)
{
    const double levels = std::log(schedule.endScalePx / schedule.startScalePx) / std::log(schedule.shrink);
    return levels * schedule.stepsPerScale + schedule.maxFinalSteps + 1.0;
}

/// Returns the final scale implied by the current estimate of the residual noise.
double endScaleOf(const RefinementSchedule& schedule, const AlignmentAtScale& problem, const CentroidPose& pose)
{
    const double ofNoisePx = std::min(problem.scalePx(), scalePerNoise * problem.noisePx(pose));
    return std::max(schedule.endScalePx, ofNoisePx);
}

}   // namespace

RefinementResult refine(Alignment& alignment, const InitialPosePrior& prior, const CentroidPose& start,
                        const RefinementSchedule& schedule, const RefinementObserver& observe)
{
    AlignmentAtScale problem(alignment, prior, schedule);
    const StepOptions steps{.minMotionMm = settledRefinementMm,
                            .minGain = settledGainPx2 * static_cast<double>(alignment.size())};
    DampedDescent descent(problem, start, alignment.buffers().evaluations, steps);
    RefinementResult result;
    const double wholeSteps = estimatedSteps(schedule);
    const auto report = [&](const StepOutcome&) {
        ++result.steps;
        return observe ? observe({descent.state(), problem.scalePx(), std::min(1.0, result.steps / wholeSteps)})
                       : ObserverDecision::Continue;
    };
    const auto finish = [&](StopReason reason) {
        result.pose = descent.state();
        result.scalePx = problem.scalePx();
        result.stopReason = reason;
        return result;
    };
    double endScalePx = schedule.endScalePx;
    while (true) {
        const bool isLast = problem.scalePx() <= endScalePx;
        const int wanted = isLast ? schedule.maxFinalSteps : schedule.stepsPerScale;
        const int left = schedule.maxSteps - result.steps;
        const StepOutcome last = descent.descend(std::min(wanted, left), report);
        if (last.isStopped) {
            return finish(StopReason::StoppedByUser);
        }
        if (wanted > left && !last.isConverged) {
            return finish(StopReason::IterationLimit);
        }
        if (isLast) {
            return finish(StopReason::Converged);
        }
        if (problem.scalePx() < maxNoiseScalePx) {
            endScalePx = endScaleOf(schedule, problem, descent.state());
        }
        problem.setScale(std::max(endScalePx, schedule.shrink * problem.scalePx()));
        alignment.setVisibility(descent.evaluation());
        descent.reevaluate();
        descent.resetDamping();
    }
}

}   // namespace angiopose::core
