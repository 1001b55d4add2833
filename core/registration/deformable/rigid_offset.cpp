#include "core/registration/deformable/rigid_offset.h"

#include "core/registration/deformable/deformed_result.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double minBranchMm = 10.0;   // minimum branch length for reporting
// Fraction of a motion that the model does not capture: sliding along vessels, second-order effects, other forms of
// motion. Measured on synthetic trees (bent_trust_table --family development).
constexpr double notFollowedShare = 0.06;

using StepOfPlaces = Eigen::Matrix<double, 6, Eigen::Dynamic>;
using StepsOfPlace = Eigen::Matrix<double, 3, 6>;

StepsOfPlace byStep(const Eigen::Vector3d& fromCentroid)
{
    StepsOfPlace moved;
    moved << -skew(fromCentroid), Eigen::Matrix3d::Identity();
    return moved;
}

/// Returns the knots of the rigid tree in the camera of the first view, relative to the centroid.
std::vector<Eigen::Vector3d> rigidArms(const DeformationProblem& problem)
{
    std::vector<Eigen::Vector3d> arms;
    for (const Eigen::Vector3d& place : problem.knots.positions) {
        arms.emplace_back(problem.start.rotation * (place - problem.centroidInPatient));
    }
    return arms;
}

/// Returns the pose step that best aligns the rigid tree with slightly displaced positions, as a linear function of the
/// displacements: three columns per knot, camera axes.
StepOfPlaces nearestStep(const std::vector<Eigen::Vector3d>& arms, const std::vector<double>& weights)
{
    Matrix6d squares = Matrix6d::Zero();
    StepOfPlaces pulls(6, 3 * static_cast<Eigen::Index>(arms.size()));
    for (std::size_t k = 0; k < arms.size(); ++k) {
        const StepsOfPlace moved = byStep(arms[k]);
        squares += weights[k] * moved.transpose() * moved;
        pulls.middleCols<3>(3 * static_cast<Eigen::Index>(k)) = weights[k] * moved.transpose();
    }
    return squares.ldlt().solve(pulls);
}

/// Returns the posterior of the nearest step given the rows of a fit, with the prior of the initial pose in place of
/// the fit's pose prior.
GaussianEstimate stepPosterior(const DeformationProblem& problem, const DeformationFit& fit,
                               const StepOfPlaces& nearest)
{
    MotionPrior prior = problem.prior;
    prior.pose.setZero();
    prior.motion = fit.state().variances;
    const FieldPosterior posterior(problem.kernel, prior, fit.rows());
    StepOfPlaces motionJacobian = nearest;
    for (Eigen::Index k = 0; 3 * k < nearest.cols(); ++k) {
        motionJacobian.middleCols<3>(3 * k) = nearest.middleCols<3>(3 * k) * problem.start.rotation;
    }
    return posterior.posteriorWithPose(motionJacobian.cast<float>(),
                                       problem.startStep);   // for a rigid step, the nearest step is the step itself
}

/// Whether the views measure the depth, as only several views do whose relative shift is known better than the pose's.
bool isDepthMeasured(const DeformationProblem& problem)
{
    return problem.views.size() > 1 && problem.prior.geometry(5, 5) <= problem.prior.pose(5, 5);
}

/// Returns the shift between two points: in 3-D if the depth is measured, otherwise in the image plane at their depth.
double shiftMm(bool inSpace, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
    return inSpace ? (to - from).norm() : (to.head<2>() - to.z() / from.z() * from.head<2>()).norm();
}

/// Computes the mean and largest distance between the knots at the rigid pose and at their actual positions.
void measureShifts(const VesselTree& tree, const DeformationProblem& problem, const KnotPositions& from,
                   const KnotPositions& to, RigidOffset& offset)
{
    const TreeKnots& knots = problem.knots;
    const bool inSpace = isDepthMeasured(problem);
    double sum = 0.0;
    double total = 0.0;
    for (std::size_t b = 0; b + 1 < knots.firstOfBranch.size(); ++b) {
        double ofBranch = 0.0;
        double lengthMm = 0.0;
        for (std::size_t k = knots.firstOfBranch[b]; k < knots.firstOfBranch[b + 1]; ++k) {
            ofBranch += knots.lengthMm[k] * shiftMm(inSpace, from[k], to[k]);
            lengthMm += knots.lengthMm[k];
        }
        if (lengthMm >= minBranchMm && ofBranch / lengthMm > offset.farthestMm) {
            offset.farthestMm = ofBranch / lengthMm;
            offset.farthestBranchId = tree.branches[b].id;
        }
        sum += ofBranch;
        total += lengthMm;
    }
    offset.meanMm = total > 0.0 ? sum / total : 0.0;
}

}   // namespace

RigidOffset rigidOffset(const VesselTree& tree, const DeformationProblem& problem,
                        const std::vector<DeformationFit>& fits, std::size_t best)
{
    RigidOffset offset;
    if (!fits[best].posterior()) {
        return offset;
    }
    const std::vector<Eigen::Vector3d> arms = rigidArms(problem);
    const StepOfPlaces nearest = nearestStep(arms, problem.knots.lengthMm);
    const GaussianEstimate estimate = stepPosterior(problem, fits[best], nearest);
    offset.step = estimate.mean;
    offset.covariance = covarianceInflation(fits[best]) * estimate.covariance;
    const KnotPositions bestPositions = knotPositionsInCamera(problem, fits[best]);
    const std::vector<double> shares = fitWeights(fits, best);
    for (std::size_t run = 0; run < fits.size(); ++run) {
        const KnotPositions positions = knotPositionsInCamera(problem, fits[run]);
        Vector6d apart = Vector6d::Zero();
        for (std::size_t k = 0; k < positions.size(); ++k) {
            apart += nearest.middleCols<3>(3 * static_cast<Eigen::Index>(k)) * (positions[k] - bestPositions[k]);
        }
        offset.covariance += shares[run] * apart * apart.transpose();
    }
    KnotPositions rigidPlaces;
    double squares = 0.0;
    for (const Eigen::Vector3d& arm : arms) {
        rigidPlaces.push_back(problem.start.centroidInCamera + arm);
        squares += arm.squaredNorm();
    }
    offset.spreadMm = std::sqrt(squares / static_cast<double>(arms.size()));
    measureShifts(tree, problem, rigidPlaces, bestPositions, offset);
    const double leftMm = notFollowedShare * offset.meanMm;
    offset.covariance.diagonal().head<3>().array() += std::pow(leftMm / offset.spreadMm, 2);
    offset.covariance.diagonal().tail<3>().array() += leftMm * leftMm;
    return offset;
}

}   // namespace angiopose::core
