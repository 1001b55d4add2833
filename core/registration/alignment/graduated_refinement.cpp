#include "core/registration/alignment/graduated_refinement.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double settledRefinementMm = 1e-3;   // 0.003 px
constexpr double noiseMattersPx = 5.0;   // above, the scale is wider than any noise
constexpr double madToStd = 1.4826;

/// One refinement under way.
class Refinement {
public:
    Refinement(Alignment& alignment, const StartPrior& prior, const CentroidPose& start,
               const RefinementSchedule& schedule)
        : alignment_(alignment),
          prior_(prior),
          pose_(start),
          scalePx_(schedule.startScalePx),
          bothWays_(schedule.bothWays),
          current_(alignment.buffers().current),
          trial_(alignment.buffers().trial),
          residuals_(alignment.buffers().residuals)
    {
        lookAt(pose_, current_);
    }

    void setScale(double scalePx)
    {
        scalePx_ = scalePx;
        alignment_.setVisibility(current_);
        lookAt(pose_, current_);
        damping_.reset();
    }

    /// Tries one step; the distance that the tree moved, mm.
    double step(double spreadMm)
    {
        const Vector6d step = prior_.freedom.dampedStep(current_.equations, damping_.factor(), pose_);
        const double promised = predictedDecrease(current_.equations, step);
        const CentroidPose trial = prior_.freedom.moved(pose_, step);
        lookAt(trial, trial_);
        const double gained = current_.loss - trial_.loss;
        const double lengthMm = spreadMm * step.head<3>().norm() + step.tail<3>().norm();
        if (gained < 0.0 || !(promised > 0.0)) {
            damping_.reject();
            return gained < 0.0 ? lengthMm : 0.0;
        }
        damping_.accept(gained / promised);
        pose_ = trial;
        std::swap(current_, trial_);
        return lengthMm;
    }

    const CentroidPose& pose() const { return pose_; }
    double scalePx() const { return scalePx_; }

    /// Robust standard deviation of the residuals of the points that agree.
    double noisePx()
    {
        alignment_.collectResiduals(pose_, 2.0 * scalePx_, residuals_);
        std::erase_if(residuals_, [](double residual) { return std::isnan(residual); });
        if (residuals_.empty()) {
            return scalePx_;
        }
        const auto middle = residuals_.begin() + static_cast<std::ptrdiff_t>(residuals_.size() / 2);
        std::nth_element(residuals_.begin(), middle, residuals_.end(),
                         [](double a, double b) { return std::abs(a) < std::abs(b); });
        return madToStd * std::abs(*middle);
    }

private:
    void lookAt(const CentroidPose& pose, Agreement& agreement) const
    {
        alignment_.look(pose, scalePx_, agreement);
        if (bothWays_) {
            alignment_.addReverse(pose, scalePx_, agreement);
        }
        const double variance = noiseVariance(scalePx_);
        prior_.add(pose, variance, agreement.equations);
        agreement.loss += variance * prior_.cost(pose);
    }

    Alignment& alignment_;
    const StartPrior& prior_;
    CentroidPose pose_;
    double scalePx_;
    bool bothWays_;
    Damping damping_;
    Agreement& current_;
    Agreement& trial_;
    std::vector<double>& residuals_;
};

}   // namespace

RefinementResult refine(Alignment& alignment, const StartPrior& prior, const CentroidPose& start,
                        const RefinementSchedule& schedule, const RefinementObserver& observe)
{
    constexpr double spreadMm = 50.0;
    Refinement refinement(alignment, prior, start, schedule);
    RefinementResult result;
    const double levels = std::log(schedule.endScalePx / schedule.startScalePx) / std::log(schedule.shrink);
    const double expectedSteps = levels * schedule.stepsPerScale + schedule.lastSteps + 1.0;
    const auto finish = [&](StopReason reason) {
        result.pose = refinement.pose();
        result.scalePx = refinement.scalePx();
        result.stopReason = reason;
        return result;
    };
    double endScalePx = schedule.endScalePx;
    while (true) {
        const bool isLast = refinement.scalePx() <= endScalePx;
        const int steps = isLast ? schedule.lastSteps : schedule.stepsPerScale;
        for (int k = 0; k < steps; ++k) {
            if (result.steps >= schedule.maxSteps) {
                return finish(StopReason::IterationLimit);
            }
            const double movedMm = refinement.step(spreadMm);
            ++result.steps;
            if (observe && observe({refinement.pose(), refinement.scalePx(),
                                    std::min(1.0, result.steps / expectedSteps)}) == Verdict::Stop) {
                return finish(StopReason::StoppedByUser);
            }
            if (movedMm < settledRefinementMm) {
                break;
            }
        }
        if (isLast) {
            return finish(StopReason::Converged);
        }
        if (refinement.scalePx() < noiseMattersPx) {
            endScalePx =
                std::max(schedule.endScalePx, std::min(refinement.scalePx(), scalePerNoise * refinement.noisePx()));
        }
        refinement.setScale(std::max(endScalePx, schedule.shrink * refinement.scalePx()));
    }
}

}   // namespace angiopose::core