#include "core/registration/wire/wire_fit.h"

#include "core/registration/pose/damped_descent.h"
#include "core/support/symmetric.h"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr std::array reachesMm{3.0, 1.5};
constexpr int roundsPerReach = 2;
constexpr int finalRounds = 5;
constexpr int stepsPerRound = 4;
constexpr double settledWireMm = 0.01;
constexpr double alongShare = 0.05;   // weight of a shift along the wire, which is barely visible

/// Measurement from one matched pair: position across the wire, weakly along it, and shape of the preceding step.
struct WireMeasurement {
    Eigen::Vector3d position;   // knot relative to the centroid, patient axes, mm
    Eigen::Vector3d before;   // knot at the start of the step, in the same frame
    Eigen::Vector2d pixel;
    Eigen::Matrix2d whitening;   // converts px to σ
    Eigen::Vector2d stepPx;   // corresponding step of the wire
    Eigen::Matrix2d shape;   // converts px of the step difference to σ; zero if the step carries no information
};

/// Least-squares problem for the −2 log posterior of a pose with fixed pairs.
class WireSquares {
public:
    struct EvaluationAt {
        double cost = 0.0;
        NormalEquations equations;
    };
    using State = CentroidPose;
    using Step = Vector6d;
    using Evaluation = EvaluationAt;
    using Equations = NormalEquations;

    WireSquares(const WireProblem& problem, const std::vector<WireMeasurement>& measurements)
        : problem_(problem), measurements_(measurements)
    {
    }

    bool evaluate(const CentroidPose& pose, EvaluationAt& evaluation) const
    {
        evaluation = {problem_.prior.cost(pose), {}};
        problem_.prior.add(pose, 1.0, evaluation.equations);
        for (const WireMeasurement& measurement : measurements_) {
            const std::optional<ProjectedKnot> here = projected(pose, measurement.position);
            const std::optional<ProjectedKnot> before = projected(pose, measurement.before);
            if (!here || !before) {
                return false;
            }
            add(measurement.whitening * (here->pixel - measurement.pixel), measurement.whitening * here->jacobian,
                evaluation);
            add(measurement.shape * (here->pixel - before->pixel - measurement.stepPx),
                measurement.shape * (here->jacobian - before->jacobian), evaluation);
        }
        return true;
    }

    const NormalEquations& equations(const CentroidPose&, const EvaluationAt& evaluation) const
    {
        return evaluation.equations;
    }

    Vector6d step(const CentroidPose& pose, const NormalEquations& equations, double damping) const
    {
        return problem_.prior.freedom.dampedStep(equations, damping, pose);
    }

    CentroidPose retract(const CentroidPose& pose, const Vector6d& step) const
    {
        return problem_.prior.freedom.retract(pose, step);
    }

    std::optional<double> decrease(const EvaluationAt& here, const EvaluationAt& there) const
    {
        return there.cost <= here.cost ? std::optional(here.cost - there.cost) : std::nullopt;
    }

    double lengthMm(const CentroidPose&, const Vector6d& step) const { return stepLengthMm(step, problem_.spreadMm); }

private:
    struct ProjectedKnot {
        Eigen::Vector2d pixel;
        Eigen::Matrix<double, 2, 6> jacobian;   // derivative of the pixel with respect to the pose step
    };

    std::optional<ProjectedKnot> projected(const CentroidPose& pose, const Eigen::Vector3d& position) const
    {
        const Eigen::Vector3d rotated = pose.rotation * position;
        const Eigen::Vector3d inCamera = rotated + pose.centroidInCamera;
        const auto pixel = project(problem_.camera, inCamera);
        if (!pixel) {
            return std::nullopt;
        }
        const Eigen::Matrix<double, 2, 3> byPoint = projectionJacobian(problem_.camera, inCamera);
        ProjectedKnot projected{*pixel, {}};
        projected.jacobian << -byPoint * skew(rotated), byPoint;
        return projected;
    }

    static void add(const Eigen::Vector2d& residual, const Eigen::Matrix<double, 2, 6>& jacobian,
                    EvaluationAt& evaluation)
    {
        evaluation.cost += residual.squaredNorm();
        evaluation.equations.hessian += jacobian.transpose() * jacobian;
        evaluation.equations.gradient += jacobian.transpose() * residual;
    }

    const WireProblem& problem_;
    const std::vector<WireMeasurement>& measurements_;
};

/// Returns σ per px, along and across the wire, of the difference between a step of the path and that of the wire.
Eigen::Matrix2d shapeOf(const WireModel& model, const StepCost& step, const Eigen::Matrix2d& axes, double mmPerPx)
{
    if (step.cost >= model.maxShapeCost * step.lengthMm / model.shapeMm || step.lengthMm <= WireModel::minStepMm) {
        return Eigen::Matrix2d::Zero();
    }
    const double perMm = 1.0 / std::sqrt(step.lengthMm * model.shapeMm);
    return mmPerPx * perMm * Eigen::Vector2d(1.0 / model.stretch, 1.0 / model.turn).asDiagonal() * axes;
}

std::vector<WireMeasurement> measurementsOf(const WireProblem& problem, const TreePath& way,
                                            const ProjectedKnots& projected, const WireAlignment& alignment,
                                            const WireModel& model)
{
    const WireCurve& curve = problem.curveOf(way);
    std::vector<WireMeasurement> measurements;
    measurements.reserve(alignment.pairs.size());
    for (const WirePair& pair : alignment.pairs) {
        const Eigen::Vector2d along = curve.tangents[pair.point];
        Eigen::Matrix2d axes;
        axes << along.transpose(), -along.y(), along.x();
        const std::size_t before = pair.knot - pair.move.knots;
        const StepCost step = stepCost(model, projected.pixels[pair.knot] - projected.pixels[before], curve, pair.point,
                                       pair.move.points, projected.mmPerPx);
        const double perSigma =
            projected.mmPerPx *
            std::sqrt(pair.lengthMm / (model.positionLengthMm * model.varianceMm2(projected.radiusMm[pair.knot])));
        const double stepPx = curve.alongPx[pair.point] - curve.alongPx[pair.point - pair.move.points];
        measurements.push_back({problem.knots.positions[way.knots[pair.knot]] - problem.centroid,
                                problem.knots.positions[way.knots[before]] - problem.centroid,
                                curve.pointsPx[pair.point],
                                perSigma * Eigen::Vector2d(alongShare, 1.0).asDiagonal() * axes, stepPx * along,
                                shapeOf(model, step, axes, projected.mmPerPx)});
    }
    return measurements;
}

/// Aligns the curve with the path, then fits the pose (one iteration); returns false if the pose no longer changes.
bool alignAndFit(const WireProblem& problem, const WireModel& model, WireFit& fit)
{
    const ProjectedKnots projected = problem.projected(fit.way.knots, fit.pose);
    fit.alignment = alignWire(projected, problem.curveOf(fit.way), model);
    const std::vector<WireMeasurement> measurements = measurementsOf(problem, fit.way, projected, fit.alignment, model);
    WireSquares squares(problem, measurements);
    EvaluationPair<WireSquares::EvaluationAt> evaluations;
    DampedDescent descent(squares, fit.pose, evaluations, {.minMotionMm = settledWireMm});
    if (!descent.isFeasible()) {
        return false;
    }
    descent.descend(stepsPerRound, [](const StepOutcome&) { return ObserverDecision::Continue; });
    const bool hasMoved = stepLengthMm(stepBetween(fit.pose, descent.state()), problem.spreadMm) > settledWireMm;
    fit.pose = descent.state();
    return hasMoved;
}

/// Computes the evidence of the image relative to the prior, by a Laplace approximation about the pose.
void computeEvidence(const WireProblem& problem, const WireModel& model, WireFit& fit)
{
    const ProjectedKnots projected = problem.projected(fit.way.knots, fit.pose);
    fit.alignment = alignWire(projected, problem.curveOf(fit.way), model);
    const std::vector<WireMeasurement> measurements = measurementsOf(problem, fit.way, projected, fit.alignment, model);
    WireSquares::EvaluationAt evaluation;
    fit.logEvidence = -fit.alignment.cost - 0.5 * problem.prior.cost(fit.pose);
    if (!WireSquares(problem, measurements).evaluate(fit.pose, evaluation)) {
        return;
    }
    const StepBasis free = problem.prior.freedom.freeSteps(fit.pose);
    const Eigen::MatrixXd all =
        free.transpose() * Matrix6d(evaluation.equations.hessian.selfadjointView<Eigen::Lower>()) * free;
    const Eigen::MatrixXd before = free.transpose() * problem.prior.informationAt(fit.pose) * free;
    const auto logDeterminant = [](const Eigen::MatrixXd& matrix) {
        return 2.0 * matrix.llt().matrixLLT().diagonal().array().log().sum();
    };
    if (free.cols() > 0) {
        fit.logEvidence -= 0.5 * (logDeterminant(all) - logDeterminant(before));
        fit.covariance = free * all.llt().solve(Eigen::MatrixXd::Identity(all.rows(), all.cols())) * free.transpose();
    }
}

}   // namespace

ProjectedKnots WireProblem::projected(const std::vector<std::size_t>& knotIndices, const CentroidPose& pose) const
{
    return projectWireKnots(knots, knotIndices, camera, cameraFromPatient(pose, centroid), pose.centroidInCamera.z());
}

WireFit fitWire(const WireProblem& problem, const TreePath& way, const CentroidPose& start, const WireModel& model)
{
    WireFit fit{way, start, {}};
    WireModel reaching = model;
    for (const double reachMm : reachesMm) {
        reaching.reachMm = reachMm;
        for (int round = 0; round < roundsPerReach; ++round) {
            alignAndFit(problem, reaching, fit);
        }
    }
    for (int round = 0; round < finalRounds && alignAndFit(problem, model, fit); ++round) {
    }
    computeEvidence(problem, model, fit);
    return fit;
}

}   // namespace angiopose::core
