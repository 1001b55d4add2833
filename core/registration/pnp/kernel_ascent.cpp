#include "core/registration/pnp/kernel_ascent.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr int scaleCount = 3;
constexpr double armijo = 1e-4;
constexpr double settledAscentPx = 1e-3;

/// Ascent at one kernel width. The cost is 2σ² (N − E_data) + prior, which the kernel-weighted squares majorize.
class OneScale {
public:
    OneScale(const KernelProblem& problem, const PosePrior& prior, double scalePx)
        : problem_(problem), prior_(prior), scalePx_(scalePx)
    {
    }

    void begin(const RigidTransform& pose)
    {
        pose_ = pose;
        measureDistances(problem_, pose_, current_, scalePx_);
        cost_ = costOf(pose_, current_);
        motionPx_ = 0.5 * scalePx_;
    }

    /// Takes one step against the gradient, with rotations and shifts weighted by `metric`; returns false if no step
    /// lowers the cost.
    bool step(const Vector6d& metric, Freedom freedom);

    const RigidTransform& pose() const { return pose_; }
    const KernelDistances& distances() const { return current_; }

private:
    double costOf(const RigidTransform& pose, const KernelDistances& distances) const
    {
        return 2.0 * scalePx_ * scalePx_ * kernelLoss(distances, scalePx_) + priorCost(prior_, pose);
    }
    double largestMotionPx(const Vector6d& step) const;

    const KernelProblem& problem_;
    const PosePrior& prior_;
    double scalePx_;
    RigidTransform pose_;
    double cost_ = 0.0;
    double motionPx_ = 0.0;   ///< initial step length, measured as the largest motion of a point
    KernelDistances current_;
    KernelDistances trial_;
};

bool OneScale::step(const Vector6d& metric, Freedom freedom)
{
    NormalEquations equations = kernelEquations(problem_, current_, scalePx_);
    addPrior(prior_, pose_, equations);
    const Vector6d direction = problem_.freedom.descentDirection(equations.gradient, metric, pose_, freedom);
    const double unitPx = largestMotionPx(direction);
    if (!(unitPx > 0.0)) {
        return false;
    }
    const double slope = 2.0 * equations.gradient.dot(direction) / unitPx;   // slope of the cost per px of motion
    for (double motionPx = motionPx_; motionPx >= settledAscentPx; motionPx *= 0.5) {
        const RigidTransform candidate = problem_.freedom.retract(pose_, motionPx / unitPx * direction);
        measureDistances(problem_, candidate, trial_, scalePx_);
        const double cost = costOf(candidate, trial_);
        if (cost <= cost_ + armijo * slope * motionPx) {
            pose_ = candidate;
            cost_ = cost;
            std::swap(current_, trial_);
            motionPx_ = std::min(2.0 * motionPx, 0.5 * scalePx_);
            return true;
        }
    }
    return false;
}

double OneScale::largestMotionPx(const Vector6d& step) const
{
    double largest = 0.0;
    for (std::size_t i = 0; i < current_.inCamera.size(); ++i) {
        const Eigen::Vector3d& point = current_.inCamera[i];
        if (std::isfinite(current_.squaredPx[i])) {
            const Eigen::Vector3d motion = step.head<3>().cross(point) + step.tail<3>();
            largest = std::max(largest, (projectionJacobian(problem_.camera, point) * motion).norm());
        }
    }
    return largest;
}

/// Returns the step length per parameter for equal slopes; zero for shifts while only the rotation is solved for.
Vector6d weightsOf(StepMetric metric, SearchStage stage, double depthMm)
{
    Vector6d weights = Vector6d::Ones();
    if (metric == StepMetric::Balanced) {
        weights.head<3>().setConstant(1.0 / (depthMm * depthMm));
    }
    if (stage == SearchStage::Turn) {
        weights.tail<3>().setZero();
    }
    return weights;
}

/// Returns weights reduced where the prior is more curved than the data, because the ascent would oscillate across the
/// narrow valley of the prior.
Vector6d shortenedBy(const PosePrior& prior, const KernelProblem& problem, double depthMm, Vector6d weights)
{
    const double pixelsPerMm = problem.camera.fx / depthMm;
    const double ofPoints = static_cast<double>(problem.points.size()) * pixelsPerMm * pixelsPerMm;   // per mm²
    for (Eigen::Index k = 3; k < 6; ++k) {
        weights[k] *= ofPoints / (ofPoints + prior.strength * prior.weights[k] * prior.weights[k]);
    }
    return weights;
}

}   // namespace

KernelPnpResult KernelAscent::solve(const KernelProblem& problem, SearchStage stage, const RigidTransform& start,
                                    const KernelObserver& observe)
{
    const PosePrior none;
    const PosePrior& prior = stage == SearchStage::Full ? options_.prior : none;
    const Vector6d weights = shortenedBy(prior, problem, depthMm_, weightsOf(options_.metric, stage, depthMm_));
    const Freedom freedom = stage == SearchStage::Turn ? Freedom::Rotation : Freedom::Full;
    const double ratio = std::pow(options_.finalScalePx / options_.startScalePx, 1.0 / (scaleCount - 1));

    KernelPnpResult result;
    result.pose = start;
    result.scalePx = options_.startScalePx;
    for (int scale = 0; scale < scaleCount; ++scale) {
        OneScale ascent(problem, prior, result.scalePx);
        ascent.begin(result.pose);
        result.stopReason = StopReason::IterationLimit;
        for (int i = 0; i < options_.iterationsPerScale; ++i) {
            if (!ascent.step(weights, freedom)) {
                result.stopReason = StopReason::Converged;
                break;
            }
            ++result.iterations;
            const int step = scale * options_.iterationsPerScale + i + 1;
            if (observe &&
                observe({step, result.scalePx, ascent.pose(), &ascent.distances()}) == ObserverDecision::Stop) {
                result.pose = ascent.pose();
                result.stopReason = StopReason::StoppedByUser;
                return result;
            }
        }
        result.pose = ascent.pose();
        result.scalePx *= ratio;
    }
    result.pose.rotation = nearestRotation(result.pose.rotation);
    return result;
}

int KernelAscent::maxIterations(SearchStage) const
{
    return scaleCount * options_.iterationsPerScale;
}

}   // namespace angiopose::core
