#include "core/registration/pnp/distance_descent.h"

#include "core/registration/pnp/affine_icp.h"
#include "core/registration/pnp/source_steps.h"
#include "core/registration/pose/damped_descent.h"
#include "core/registration/pose/minimize.h"
#include "core/registration/pose/pose_parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr int descentTriesPerStep = 8;
constexpr double settledDescentShare = 1e-6;   // relative decrease of the cost at which the descent ends (§3.6)
constexpr double wholeSquares = 1e9;   // Huber threshold in px that makes the loss quadratic everywhere

/// Distances and loss of the points at one pose.
struct HuberEvaluation {
    KernelDistances distances;
    double loss = 0.0;
};

/// Huber loss of the nearest-point distances, with matches updated at every evaluation.
class HuberSquares : public SourceSteps {
public:
    using Evaluation = HuberEvaluation;

    HuberSquares(const KernelProblem& problem, Freedom freedom, double huberPx)
        : SourceSteps(problem, freedom), huberPx_(huberPx)
    {
    }

    bool evaluate(const RigidTransform& pose, HuberEvaluation& evaluation) const
    {
        measureDistances(problem(), pose, evaluation.distances);
        evaluation.loss = huberLoss(problem(), evaluation.distances, huberPx_);
        return true;
    }

    NormalEquations equations(const RigidTransform&, const HuberEvaluation& evaluation) const
    {
        return huberEquations(problem(), evaluation.distances, huberPx_);
    }

    std::optional<double> decrease(const HuberEvaluation& here, const HuberEvaluation& there) const
    {
        return there.loss < here.loss ? std::optional(here.loss - there.loss) : std::nullopt;
    }

private:
    double huberPx_;
};

double rmsSpread(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& mean)
{
    double squares = 0.0;
    for (const Eigen::Vector3d& point : points) {
        squares += (point - mean).squaredNorm();
    }
    return std::max(1e-6, std::sqrt(squares / static_cast<double>(points.size())));
}

/// Converts steps about the source to steps about the centroid: a rotation about the centroid c' is a rotation about
/// the source plus a shift by c' × ω.
Vector6d aboutPivot(const Vector6d& gradient, const Eigen::Vector3d& pivot)
{
    Vector6d moved = gradient;
    moved.head<3>() -= pivot.cross(Eigen::Vector3d(gradient.tail<3>()));
    return moved;
}

}   // namespace

KernelPnpResult DistanceDescent::solve(const KernelProblem& problem, SearchStage stage, const RigidTransform& start,
                                       const KernelObserver& observe)
{
    if (stage == SearchStage::Turn) {
        return descend(problem, Freedom::Rotation, start, observe);
    }
    KernelPnpResult result = options_.solver == DescentSolver::Lbfgs ? descendSmoothly(problem, start, observe)
                                                                     : descend(problem, Freedom::Full, start, observe);
    if (options_.hasAffineStage && stage == SearchStage::Full && result.stopReason != StopReason::StoppedByUser) {
        tryAffine(problem, observe, result);
    }
    return result;
}

int DistanceDescent::maxIterations(SearchStage stage) const
{
    return stage == SearchStage::Full && options_.hasAffineStage ? 2 * options_.maxIterations : options_.maxIterations;
}

KernelPnpResult DistanceDescent::descend(const KernelProblem& problem, Freedom freedom, const RigidTransform& start,
                                         const KernelObserver& observe) const
{
    HuberSquares squares(problem, freedom, options_.huberPx);
    EvaluationPair<HuberEvaluation> evaluations;
    DampedDescent descent(squares, start, evaluations, {.maxTriesPerStep = descentTriesPerStep});
    KernelPnpResult result;
    result.scalePx = options_.huberPx;
    while (result.iterations < options_.maxIterations) {
        const double before = descent.evaluation().loss;
        const bool isAccepted = descent.step().isAccepted;
        if (isAccepted) {
            ++result.iterations;
            const KernelIteration step{result.iterations, options_.huberPx, descent.state(),
                                       &descent.evaluation().distances};
            if (observe && observe(step) == ObserverDecision::Stop) {
                result.stopReason = StopReason::StoppedByUser;
                break;
            }
        }
        if (!isAccepted || before - descent.evaluation().loss < settledDescentShare * before) {
            result.stopReason = StopReason::Converged;
            break;
        }
    }
    result.pose = descent.state();
    result.pose.rotation = nearestRotation(result.pose.rotation);
    return result;
}

/// Runs L-BFGS on Σ d², whose gradient, where it exists, equals that for fixed matches.
KernelPnpResult DistanceDescent::descendSmoothly(const KernelProblem& problem, const RigidTransform& start,
                                                 const KernelObserver& observe) const
{
    const SourceFreedom& freedom = problem.freedom;
    const Eigen::Vector3d centroid = freedom.isFull() ? meanOf(problem.points) : freedom.centroidInStart();
    const PoseParameters parameters(aboutCentroid(start, centroid), metricUnits(rmsSpread(problem.points, centroid)),
                                    freedom.aboutCentroid());
    KernelDistances distances;
    KernelPnpResult result;
    bool isStopped = false;
    double least = std::numeric_limits<double>::infinity();
    const auto cost = [&](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
        const CentroidPose pose = parameters.pose(x);
        const RigidTransform transform = cameraFromPatient(pose, centroid);
        measureDistances(problem, transform, distances);
        const NormalEquations equations = huberEquations(problem, distances, wholeSquares);
        gradient = 2.0 * parameters.gradient(x, aboutPivot(equations.gradient, pose.centroidInCamera));
        const double loss = huberLoss(problem, distances, wholeSquares);
        if (loss < least) {
            least = loss;
            result.pose = transform;
            ++result.iterations;
            isStopped = observe && observe({result.iterations, 0.0, transform, &distances}) == ObserverDecision::Stop;
        }
        return loss;
    };
    MinimizeOptions options;
    options.minimizer = Minimizer::Lbfgs;
    options.tolerance = 1e-6;
    options.relativeTolerance = settledDescentShare;
    options.maxEvaluations = options_.maxIterations;
    const Minimum minimum = minimize(cost, parameters.origin(), options, [&] { return isStopped; });
    result.stopReason = isStopped             ? StopReason::StoppedByUser
                        : minimum.isConverged ? StopReason::Converged
                                              : StopReason::IterationLimit;
    return result;
}

/// Fits the affine map to the target, then refines the rigid pose whose projection is closest to that map and keeps
/// this pose if it fits better than the current one.
void DistanceDescent::tryAffine(const KernelProblem& problem, const KernelObserver& observe,
                                KernelPnpResult& result) const
{
    const int before = result.iterations;
    KernelPnpResult affine = rigidPartOfAffineIcp(problem, result.pose, {options_.huberPx, options_.maxIterations},
                                                  [&](const KernelIteration& step) {
                                                      KernelIteration numbered = step;
                                                      numbered.iteration += before;
                                                      return observe ? observe(numbered) : ObserverDecision::Continue;
                                                  });
    result.iterations += affine.iterations;
    if (affine.stopReason == StopReason::StoppedByUser) {
        result.stopReason = affine.stopReason;
        return;
    }
    const auto lossAt = [&](const RigidTransform& pose) {
        KernelDistances distances;
        measureDistances(problem, pose, distances);
        return huberLoss(problem, distances, options_.huberPx);
    };
    if (lossAt(affine.pose) < lossAt(result.pose)) {
        result.pose = affine.pose;
    }
}

}   // namespace angiopose::core
