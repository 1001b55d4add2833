#include "core/registration/pnp/kernel_pnp.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr int kernelTriesPerStep = 7;   // the first, and six with more damping
constexpr double settledKernelMm = 1e-5;
constexpr double kernelReachInScales = 3.0;

}   // namespace

KernelPnp::KernelPnp(const KernelProblem& problem, const PosePrior& prior, const KernelSchedule& schedule)
    : problem_(problem),
      prior_(prior),
      schedule_(schedule),
      centroid_(Eigen::Vector3d::Zero()),
      annealing_(schedule.decay, schedule.finalScalePx, schedule.finalScalePx)
{
    assert(!problem.points.empty());
    for (const Eigen::Vector3d& point : problem.points) {
        centroid_ += point;
    }
    centroid_ /= static_cast<double>(problem.points.size());
}

KernelPnpResult KernelPnp::solve(const RigidTransform& start, const KernelObserver& observe)
{
    begin(start);
    KernelPnpResult result;
    result.stopReason = StopReason::IterationLimit;
    while (result.iterations < schedule_.maxIterations) {
        const Outcome outcome = improve();
        if (outcome != Outcome::Moved) {
            if (annealing_.sharpen()) {
                damping_.reset();
                continue;
            }
            result.stopReason = outcome == Outcome::Settled ? StopReason::Converged : StopReason::NoImprovement;
            break;
        }
        ++result.iterations;
        if (observe && observe({result.iterations, annealing_.scalePx(), pose_, &current_}) == Verdict::Stop) {
            result.stopReason = StopReason::StoppedByUser;
            break;
        }
        annealing_.noteStep(countWithin(current_, kernelReachInScales * annealing_.scalePx()));
    }
    pose_.rotation = nearestRotation(pose_.rotation);
    result.pose = pose_;
    result.scalePx = annealing_.scalePx();
    return result;
}

void KernelPnp::begin(const RigidTransform& start)
{
    pose_ = start;
    damping_.reset();
    measure(problem_, pose_, current_);
    measuredAtPx_ = 0.0;
    const double largestPx = largestDistancePx(current_);
    const double halfDiagonalPx = 0.5 * std::hypot(problem_.camera.width, problem_.camera.height);
    const double startPx =
        schedule_.startScale == StartScale::Largest ? std::min(largestPx, halfDiagonalPx) : largestPx * largestPx;
    annealing_ = ScaleAnnealing(schedule_.decay, startPx, schedule_.finalScalePx);
}

/// One damped step, accepted only if E_data at the present ℓ does not fall (fresh matches). A step too small to see
/// settles this ℓ.
KernelPnp::Outcome KernelPnp::improve()
{
    const double scalePx = annealing_.scalePx();
    if (problem_.neighbours == Neighbours::Radius && scalePx != measuredAtPx_) {
        measure(problem_, pose_, current_, scalePx);
        measuredAtPx_ = scalePx;
    }
    NormalEquations equations = kernelEquations(problem_, current_, scalePx);
    addPrior(prior_, pose_, equations);
    const double loss = kernelLoss(current_, scalePx);
    const double pull = priorCost(prior_, pose_);

    for (int attempt = 0; attempt < kernelTriesPerStep; ++attempt) {
        const Vector6d step = problem_.freedom.dampedStep(equations, damping_.factor(), pose_, schedule_.freedom);
        const RigidTransform candidate = problem_.freedom.moved(pose_, step);
        const bool isTiny = stepLengthMm(step) < settledKernelMm;
        if (isAllowed(candidate)) {
            measure(problem_, candidate, trial_, scalePx);
            const double trialLoss = kernelLoss(trial_, scalePx);
            if (trialLoss <= loss) {
                // 2ℓ²(1 − exp(−d²/2ℓ²)) is the loss that the weighted squares majorise.
                const double actual =
                    2.0 * scalePx * scalePx * (loss - trialLoss) + pull - priorCost(prior_, candidate);
                const double predicted = predictedDecrease(equations, step);
                damping_.accept(predicted > 0.0 ? actual / predicted : 0.0);
                pose_ = candidate;
                std::swap(current_, trial_);
                return isTiny ? Outcome::Settled : Outcome::Moved;
            }
        }
        if (isTiny) {
            return Outcome::Settled;
        }
        damping_.reject();
    }
    return Outcome::Stuck;
}

bool KernelPnp::isAllowed(const RigidTransform& pose) const
{
    const double depthMm = (pose * centroid_).z();
    return depthMm > schedule_.nearestMm && depthMm < schedule_.farthestMm;
}

/// Rotation counted as the shift it causes at the depth of the points.
double KernelPnp::stepLengthMm(const Vector6d& step) const
{
    const double depthMm = (pose_ * centroid_).z();
    return std::hypot(depthMm * step.head<3>().norm(), step.tail<3>().norm());
}

}   // namespace angiopose::core