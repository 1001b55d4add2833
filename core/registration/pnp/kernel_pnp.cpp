#include "core/registration/pnp/kernel_pnp.h"

#include "core/registration/pnp/source_steps.h"
#include "core/registration/pose/damped_descent.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr int kernelTriesPerStep = 7;   // one attempt plus six with increased damping
constexpr double settledKernelMm = 1e-5;
constexpr double kernelReachInScales = 3.0;

/// Distances and cost of the points at one pose.
struct KernelEvaluation {
    KernelDistances distances;
    double loss = 0.0;   ///< N − E_data at the current ℓ
    double priorTerm = 0.0;   ///< cost of the prior
    bool isInDepth = false;   ///< whether the pose respects the depth limits
};

/// Kernel-weighted squares at one ℓ plus the prior. A step is accepted unless E_data falls, whatever the prior.
class KernelAtScale : public SourceSteps {
public:
    using Evaluation = KernelEvaluation;

    KernelAtScale(const KernelProblem& problem, const PosePrior& prior, const KernelSchedule& schedule)
        : SourceSteps(problem, schedule.freedom), prior_(prior), schedule_(schedule)
    {
    }

    bool evaluate(const RigidTransform& pose, KernelEvaluation& evaluation) const
    {
        measureDistances(problem(), pose, evaluation.distances, scalePx_);
        evaluation.loss = kernelLoss(evaluation.distances, scalePx_);
        evaluation.priorTerm = priorCost(prior_, pose);
        evaluation.isInDepth = depthMm(pose) > schedule_.minDepthMm && depthMm(pose) < schedule_.maxDepthMm;
        return true;
    }

    NormalEquations equations(const RigidTransform& pose, const KernelEvaluation& evaluation) const
    {
        NormalEquations equations = kernelEquations(problem(), evaluation.distances, scalePx_);
        addPrior(prior_, pose, equations);
        return equations;
    }

    std::optional<double> decrease(const KernelEvaluation& current, const KernelEvaluation& next) const
    {
        if (!next.isInDepth || !(next.loss <= current.loss)) {
            return {};
        }
        // The weighted squares are a majorizer of the loss 2ℓ²(1 − exp(−d²/2ℓ²)).
        return 2.0 * scalePx_ * scalePx_ * (current.loss - next.loss) + current.priorTerm - next.priorTerm;
    }

    double scalePx() const { return scalePx_; }
    void setScale(double scalePx) { scalePx_ = scalePx; }

private:
    const PosePrior& prior_;
    const KernelSchedule& schedule_;
    double scalePx_ = 0.0;   ///< current ℓ; 0 to search only for the nearest matches
};

/// Returns the initial ℓ from the largest distance, see StartScale.
double startScalePx(const KernelProblem& problem, const KernelSchedule& schedule, const KernelDistances& distances)
{
    const double largestPx = maxDistancePx(distances);
    const double halfDiagonalPx = 0.5 * std::hypot(problem.camera.width, problem.camera.height);
    return schedule.startScale == StartScale::Largest ? std::min(largestPx, halfDiagonalPx) : largestPx * largestPx;
}

}   // namespace

KernelPnpResult KernelPnp::solve(const RigidTransform& start, const KernelObserver& observe)
{
    KernelAtScale atScale(problem_, prior_, schedule_);
    EvaluationPair<KernelEvaluation> evaluations;
    DampedDescent descent(atScale, start, evaluations, {kernelTriesPerStep, settledKernelMm});
    const auto setScale = [&](double scalePx) {
        if (scalePx == atScale.scalePx()) {
            return;
        }
        atScale.setScale(scalePx);
        if (problem_.neighbors == Neighbors::Radius) {
            descent.reevaluate();
        } else {   // unchanged matches with different weights
            descent.evaluation().loss = kernelLoss(descent.evaluation().distances, scalePx);
            descent.relinearize();
        }
    };
    ScaleAnnealing annealing(schedule_.decay, startScalePx(problem_, schedule_, evaluations.current.distances),
                             schedule_.finalScalePx);
    setScale(annealing.scalePx());

    KernelPnpResult result;
    result.stopReason = StopReason::IterationLimit;
    while (result.iterations < schedule_.maxIterations) {
        const StepOutcome outcome = descent.step();
        if (outcome.isConverged || !outcome.isAccepted) {
            if (annealing.shrinkScale()) {
                setScale(annealing.scalePx());
                descent.resetDamping();
                continue;
            }
            result.stopReason = outcome.isConverged ? StopReason::Converged : StopReason::NoImprovement;
            break;
        }
        ++result.iterations;
        const KernelDistances& distances = descent.evaluation().distances;
        if (observe &&
            observe({result.iterations, annealing.scalePx(), descent.state(), &distances}) == ObserverDecision::Stop) {
            result.stopReason = StopReason::StoppedByUser;
            break;
        }
        annealing.countStep(countWithin(distances, kernelReachInScales * annealing.scalePx()));
        setScale(annealing.scalePx());
    }
    result.pose = descent.state();
    result.pose.rotation = nearestRotation(result.pose.rotation);
    result.scalePx = annealing.scalePx();
    return result;
}

}   // namespace angiopose::core
