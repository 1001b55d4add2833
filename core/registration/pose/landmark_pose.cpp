#include "core/registration/pose/landmark_pose.h"

#include "core/geometry/angle_units.h"
#include "core/messages/messages.h"
#include "core/registration/pose/centroid_pose.h"
#include "core/registration/pose/damped_descent.h"
#include "core/registration/pose/initial_pose_prior.h"
#include "core/registration/pose/sqpnp.h"
#include "core/support/symmetric.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr double clickStdPx = 2.0;
constexpr double minSpreadMm = 1.0;   // RMS distance from a line; below, the rotation about the line is undetermined
constexpr double minSpreadPx = 3.0;
constexpr int maxLandmarkSteps = 60;
constexpr double settledLandmarksMm = 1e-7;
constexpr double asGood = 1.5;   // factor up to which costs count as equal; differences below one click error always do

// Prior for the parameters that remain undetermined with few pairs: out-of-plane rotation costs more than roll, roll
// more than a shift, depth more than a lateral shift.
constexpr double priorTurnDeg = 8.0;
constexpr double priorRollDeg = 60.0;
constexpr double priorShiftMm = 1000.0;
constexpr double priorDepthMm = 30.0;

/// Cost of a pose: squared pixel errors in units of the click error, plus, for few pairs, the prior at the previous
/// pose.
struct LandmarkEvaluation {
    double cost = std::numeric_limits<double>::infinity();
    NormalEquations equations;
};

/// Least-squares problem for the landmark pose, with steps about the landmarks' centroid.
class LandmarkSquares {
public:
    using State = CentroidPose;
    using Step = Vector6d;
    using Evaluation = LandmarkEvaluation;
    using Equations = NormalEquations;

    LandmarkSquares(std::span<const Landmark> landmarks, const ProjectionCamera& camera,
                    const std::optional<InitialPosePrior>& prior)
        : landmarks_(landmarks), camera_(camera), prior_(prior), centroid_(Eigen::Vector3d::Zero())
    {
        for (const Landmark& landmark : landmarks) {
            centroid_ += landmark.pointInPatient / static_cast<double>(landmarks.size());
        }
        for (const Landmark& landmark : landmarks) {
            spreadMm_ = std::max(spreadMm_, (landmark.pointInPatient - centroid_).norm());
        }
    }
    const Eigen::Vector3d& centroid() const { return centroid_; }

    /// Evaluates a pose; returns false if a landmark is not in front of the source.
    bool evaluate(const CentroidPose& pose, LandmarkEvaluation& evaluation) const
    {
        evaluation = {0.0, {}};
        for (const Landmark& landmark : landmarks_) {
            const Eigen::Vector3d rotated = pose.rotation * (landmark.pointInPatient - centroid_);
            const auto pixel = project(camera_, rotated + pose.centroidInCamera);
            if (!pixel) {
                return false;
            }
            const Eigen::Vector2d residual = (*pixel - landmark.pixel) / clickStdPx;
            evaluation.cost += residual.squaredNorm();
            add(rotated, rotated + pose.centroidInCamera, residual, evaluation.equations);
        }
        if (prior_) {
            evaluation.cost += prior_->cost(pose);
            prior_->add(pose, 1.0, evaluation.equations);
        }
        return true;
    }

    const NormalEquations& equations(const CentroidPose&, const LandmarkEvaluation& evaluation) const
    {
        return evaluation.equations;
    }

    Vector6d step(const CentroidPose&, const NormalEquations& equations, double damping) const
    {
        return dampedStep(equations, damping);
    }

    CentroidPose retract(const CentroidPose& pose, const Vector6d& step) const { return core::retract(pose, step); }

    std::optional<double> decrease(const LandmarkEvaluation& here, const LandmarkEvaluation& there) const
    {
        return there.cost <= here.cost ? std::optional(here.cost - there.cost) : std::nullopt;
    }

    double lengthMm(const CentroidPose&, const Vector6d& step) const { return stepLengthMm(step, spreadMm_); }

private:
    void add(const Eigen::Vector3d& rotated, const Eigen::Vector3d& inCamera, const Eigen::Vector2d& residual,
             NormalEquations& equations) const
    {
        const Eigen::Matrix<double, 2, 3> byPoint = projectionJacobian(camera_, inCamera) / clickStdPx;
        Eigen::Matrix<double, 2, 6> jacobian;
        jacobian << -byPoint * skew(rotated), byPoint;
        equations.hessian += jacobian.transpose() * jacobian;
        equations.gradient += jacobian.transpose() * residual;
    }

    std::span<const Landmark> landmarks_;
    const ProjectionCamera& camera_;
    std::optional<InitialPosePrior> prior_;
    Eigen::Vector3d centroid_;
    double spreadMm_ = 0.0;   ///< distance of the farthest landmark from the centroid
};

struct Fit {
    CentroidPose pose;
    double cost = std::numeric_limits<double>::infinity();
};

Fit refined(LandmarkSquares& squares, const CentroidPose& start)
{
    EvaluationPair<LandmarkEvaluation> evaluations;
    DampedDescent descent(squares, start, evaluations, {.minMotionMm = settledLandmarksMm});
    if (!descent.isFeasible()) {
        return {start};
    }
    descent.descend(maxLandmarkSteps, [](const StepOutcome&) { return ObserverDecision::Continue; });
    return {descent.state(), descent.evaluation().cost};
}

/// Returns the standard deviation of points, one per column, along the axis of largest spread (`rank` 0) or a smaller
/// one.
template <int Size>
double rmsSpread(const Eigen::Matrix<double, Size, Eigen::Dynamic>& points, int rank)
{
    Eigen::Matrix<double, Size, Size> scatter = Eigen::Matrix<double, Size, Size>::Zero();
    const Eigen::Vector<double, Size> mean = points.rowwise().mean();
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const Eigen::Vector<double, Size> offset = points.col(i) - mean;
        scatter += offset * offset.transpose() / static_cast<double>(points.cols());
    }
    return std::sqrt(std::max(0.0, eigenDecomposition(scatter).values[Size - 1 - rank]));
}

std::optional<Message> findDegeneracy(std::span<const Landmark> landmarks, bool hasBefore)
{
    if (landmarks.empty()) {
        return messages::landmarksMissing();
    }
    const bool isEnough = landmarks.size() >= minLandmarks;
    if (!isEnough && !hasBefore) {
        return messages::landmarksTooFew(landmarks.size());
    }
    Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(landmarks.size()));
    Eigen::Matrix2Xd pixels(2, static_cast<Eigen::Index>(landmarks.size()));
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        points.col(static_cast<Eigen::Index>(i)) = landmarks[i].pointInPatient;
        pixels.col(static_cast<Eigen::Index>(i)) = landmarks[i].pixel;
    }
    if (!points.allFinite() || !pixels.allFinite()) {
        return messages::landmarksNotFinite();
    }
    if (landmarks.size() > 1 && (rmsSpread<3>(points, 0) < minSpreadMm || rmsSpread<2>(pixels, 0) < minSpreadPx)) {
        return messages::landmarksCoincide();
    }
    if (isEnough && rmsSpread<3>(points, 1) < minSpreadMm) {
        return messages::landmarksCollinear();
    }
    return {};
}

InitialPosePrior priorAt(const CentroidPose& knownPose)
{
    const double turn = priorTurnDeg / degreesPerRadian;
    Vector6d std;
    std << turn, turn, priorRollDeg / degreesPerRadian, priorShiftMm, priorShiftMm, priorDepthMm;
    return independentPrior(knownPose, std);
}

/// Returns the better of two fits, or `near` if both are about equally good.
const Fit& chosen(const Fit& near, const Fit& other)
{
    const double showsNothing = asGood * other.cost + 1.0;
    return near.cost <= showsNothing ? near : other;
}

LandmarkPose assessLandmarkFit(const LandmarkSquares& squares, const Fit& fit, std::span<const Landmark> landmarks,
                               const ProjectionCamera& camera)
{
    LandmarkPose result;
    result.cameraFromPatient = cameraFromPatient(fit.pose, squares.centroid());
    result.errorPx = landmarkErrorsPx(landmarks, camera, result.cameraFromPatient);
    double sum = 0.0;
    for (const double error : result.errorPx) {
        sum += error * error / static_cast<double>(result.errorPx.size());
    }
    result.rmsPx = std::sqrt(sum);
    LandmarkEvaluation evaluation;
    squares.evaluate(fit.pose, evaluation);
    const Matrix6d full = evaluation.equations.hessian.selfadjointView<Eigen::Lower>();
    const Matrix6d covariance = inverseOf(full);
    result.depthStdMm = std::sqrt(std::max(0.0, covariance(5, 5)));
    result.rotationStdDeg = degreesPerRadian * std::sqrt(std::max(0.0, covariance.diagonal().head<3>().maxCoeff()));
    return result;
}

std::optional<RigidTransform> solveWithoutPrior(std::span<const Landmark> landmarks, const ProjectionCamera& camera)
{
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector2d> pixels;
    for (const Landmark& landmark : landmarks) {
        points.push_back(landmark.pointInPatient);
        pixels.push_back(landmark.pixel);
    }
    return solveSqpnp(points, pixels, camera);
}

}   // namespace

std::vector<double> landmarkErrorsPx(std::span<const Landmark> landmarks, const ProjectionCamera& camera,
                                     const RigidTransform& cameraFromPatient)
{
    std::vector<double> errors;
    for (const Landmark& landmark : landmarks) {
        const auto pixel = project(camera, cameraFromPatient * landmark.pointInPatient);
        errors.push_back(pixel ? (*pixel - landmark.pixel).norm() : std::numeric_limits<double>::infinity());
    }
    return errors;
}

Result<LandmarkPose> poseFromLandmarks(std::span<const Landmark> landmarks, const ProjectionCamera& camera,
                                       const std::optional<RigidTransform>& knownPose)
{
    if (const auto degeneracy = findDegeneracy(landmarks, knownPose.has_value())) {
        return Error(*degeneracy);
    }
    const bool isEnough = landmarks.size() >= minLandmarks;
    const Eigen::Vector3d centroid = LandmarkSquares(landmarks, camera, std::nullopt).centroid();
    const auto start = knownPose ? std::optional(aboutCentroid(*knownPose, centroid)) : std::nullopt;
    LandmarkSquares squares(landmarks, camera, isEnough ? std::nullopt : std::optional(priorAt(*start)));

    const Fit near = start ? refined(squares, *start) : Fit{};
    const auto alone = isEnough ? solveWithoutPrior(landmarks, camera) : std::nullopt;
    const Fit other = alone ? refined(squares, aboutCentroid(*alone, centroid)) : Fit{};
    const Fit& best = chosen(near, other);
    if (!std::isfinite(best.cost)) {
        return Error(messages::landmarksWithoutPose());
    }
    LandmarkPose result = assessLandmarkFit(squares, best, landmarks, camera);
    result.usesPrior = !isEnough;
    return result;
}

}   // namespace angiopose::core
