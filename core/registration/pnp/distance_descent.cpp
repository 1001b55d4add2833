#include "core/registration/pnp/distance_descent.h"

#include "core/registration/pnp/affine_icp.h"
#include "core/registration/pose/minimise.h"
#include "core/registration/pose/pose_parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr int descentTriesPerStep = 8;
constexpr double settledDescentShare = 1e-6;   // of the cost, §3.6
constexpr double wholeSquares = 1e9;   // px: Huber's loss that never turns linear

/// Damped Gauss–Newton on one loss, matches fresh at every look.
class SmoothDescent {
public:
    SmoothDescent(const KernelProblem& problem, double huberPx, Freedom freedom, const RigidTransform& start)
        : problem_(problem), huberPx_(huberPx), freedom_(freedom), pose_(start)
    {
        measure(problem_, pose_, current_);
        loss_ = huberLoss(problem_, current_, huberPx_);
    }

    /// Share of the loss that a step took away; 0 when none lowers it.
    double step()
    {
        const NormalEquations equations = huberEquations(problem_, current_, huberPx_);
        for (int attempt = 0; attempt < descentTriesPerStep; ++attempt) {
            const Vector6d step = problem_.freedom.dampedStep(equations, damping_.factor(), pose_, freedom_);
            const RigidTransform candidate = problem_.freedom.moved(pose_, step);
            measure(problem_, candidate, trial_);
            const double loss = huberLoss(problem_, trial_, huberPx_);
            if (loss < loss_) {
                const double promised = predictedDecrease(equations, step);
                damping_.accept(promised > 0.0 ? (loss_ - loss) / promised : 0.0);
                const double share = (loss_ - loss) / loss_;
                pose_ = candidate;
                loss_ = loss;
                std::swap(current_, trial_);
                return share;
            }
            damping_.reject();
        }
        return 0.0;
    }

    const RigidTransform& pose() const { return pose_; }
    const KernelDistances& distances() const { return current_; }

private:
    const KernelProblem& problem_;
    double huberPx_;
    Freedom freedom_;
    RigidTransform pose_;
    double loss_ = 0.0;
    Damping damping_;
    KernelDistances current_;
    KernelDistances trial_;
};

Eigen::Vector3d meanOf(std::span<const Eigen::Vector3d> points)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points) {
        sum += point;
    }
    return sum / static_cast<double>(points.size());
}

double spreadOf(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& mean)
{
    double squares = 0.0;
    for (const Eigen::Vector3d& point : points) {
        squares += (point - mean).squaredNorm();
    }
    return std::max(1e-6, std::sqrt(squares / static_cast<double>(points.size())));
}

/// From steps about the source to steps about the centroid: turning about the centroid c' is turning about the source
/// and shifting by c' × ω.
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
    SmoothDescent descent(problem, options_.huberPx, freedom, start);
    KernelPnpResult result;
    result.scalePx = options_.huberPx;
    while (result.iterations < options_.maxIterations) {
        const double share = descent.step();
        if (share > 0.0) {
            ++result.iterations;
            const KernelIteration step{result.iterations, options_.huberPx, descent.pose(), &descent.distances()};
            if (observe && observe(step) == Verdict::Stop) {
                result.stopReason = StopReason::StoppedByUser;
                break;
            }
        }
        if (share < settledDescentShare) {
            result.stopReason = StopReason::Converged;
            break;
        }
    }
    result.pose = descent.pose();
    result.pose.rotation = nearestRotation(result.pose.rotation);
    return result;
}

/// L-BFGS on Σ d², whose gradient is that of the held matches wherever it exists.
KernelPnpResult DistanceDescent::descendSmoothly(const KernelProblem& problem, const RigidTransform& start,
                                                 const KernelObserver& observe) const
{
    const SourceFreedom& freedom = problem.freedom;
    const Eigen::Vector3d centroid = freedom.isFull() ? meanOf(problem.points) : freedom.centroidInStart();
    const PoseParameters parameters(aboutCentroid(start, centroid), metricUnits(spreadOf(problem.points, centroid)),
                                    freedom.aboutCentroid());
    KernelDistances distances;
    KernelPnpResult result;
    bool isStopped = false;
    double least = std::numeric_limits<double>::infinity();
    const auto cost = [&](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
        const CentroidPose pose = parameters.pose(x);
        const RigidTransform transform = cameraFromPatient(pose, centroid);
        measure(problem, transform, distances);
        const NormalEquations equations = huberEquations(problem, distances, wholeSquares);
        gradient = 2.0 * parameters.gradient(x, aboutPivot(equations.gradient, pose.centroidInCamera));
        const double loss = huberLoss(problem, distances, wholeSquares);
        if (loss < least) {
            least = loss;
            result.pose = transform;
            ++result.iterations;
            isStopped = observe && observe({result.iterations, 0.0, transform, &distances}) == Verdict::Stop;
        }
        return loss;
    };
    MinimiseOptions options;
    options.minimiser = Minimiser::Lbfgs;
    options.tolerance = 1e-6;
    options.relativeTolerance = settledDescentShare;
    options.maxEvaluations = options_.maxIterations;
    const Minimum minimum = minimise(cost, parameters.origin(), options, [&] { return isStopped; });
    result.stopReason = isStopped             ? StopReason::StoppedByUser
                        : minimum.isConverged ? StopReason::Converged
                                              : StopReason::IterationLimit;
    return result;
}

/// The affine map bends towards the target as far as it can; the rigid pose nearest to it in the image, refined, is
/// kept if it fits better than the one there is.
void DistanceDescent::tryAffine(const KernelProblem& problem, const KernelObserver& observe,
                                KernelPnpResult& result) const
{
    const int before = result.iterations;
    KernelPnpResult affine = rigidPartOfAffineIcp(problem, result.pose, {options_.huberPx, options_.maxIterations},
                                                  [&](const KernelIteration& step) {
                                                      KernelIteration numbered = step;
                                                      numbered.iteration += before;
                                                      return observe ? observe(numbered) : Verdict::Continue;
                                                  });
    result.iterations += affine.iterations;
    if (affine.stopReason == StopReason::StoppedByUser) {
        result.stopReason = affine.stopReason;
        return;
    }
    const auto lossAt = [&](const RigidTransform& pose) {
        KernelDistances distances;
        measure(problem, pose, distances);
        return huberLoss(problem, distances, options_.huberPx);
    };
    if (lossAt(affine.pose) < lossAt(result.pose)) {
        result.pose = affine.pose;
    }
}

}   // namespace angiopose::core