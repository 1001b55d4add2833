#include "core/registration/deformable/deformed_result.h"

#include "core/registration/deformable/deformed_tree.h"
#include "core/registration/deformable/rigid_offset.h"
#include "core/vessel/polyline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

// Larger residuals are due to motion that the field did not capture; they are correlated along a vessel, so averaging
// does not reduce them.
constexpr double tracingNoisePx = 0.6;
constexpr double fitWeightScale = 20.0;   // a fit whose log likelihood is lower by this gets a third of the weight

/// Returns every other knot of each branch and its last one; covariances change slowly along a branch.
std::vector<std::size_t> everyOther(const TreeKnots& knots)
{
    std::vector<std::size_t> selectedKnots;
    for (std::size_t b = 0; b + 1 < knots.firstOfBranch.size(); ++b) {
        const std::size_t first = knots.firstOfBranch[b];
        const std::size_t end = knots.firstOfBranch[b + 1];
        for (std::size_t k = first; k < end; ++k) {
            if ((k - first) % 2 == 0 || k + 1 == end) {
                selectedKnots.push_back(k);
            }
        }
    }
    return selectedKnots;
}

std::vector<Eigen::Matrix3d> covariancesOf(const DeformationProblem& problem, const DeformationFit& fit,
                                           const KnotPositions& positions)
{
    const RigidTransform pose = fit.deformedTree().cameraFromPatient;
    const Eigen::Vector3d centroid = pose * problem.centroidInPatient;
    const std::vector<std::size_t> selectedKnots = everyOther(problem.knots);
    std::vector<Eigen::Matrix<double, 3, 6>> poseJacobian(selectedKnots.size());
    for (std::size_t k = 0; k < selectedKnots.size(); ++k) {
        poseJacobian[k] << -skew(positions[selectedKnots[k]] - centroid), Eigen::Matrix3d::Identity();
    }
    const std::vector<Eigen::Matrix3d> selectedCovariances =
        fit.posterior()->positionCovariances(selectedKnots, poseJacobian, pose.rotation);
    std::vector<Eigen::Matrix3d> covariances(positions.size());
    for (std::size_t k = 0; k < selectedKnots.size(); ++k) {
        covariances[selectedKnots[k]] = selectedCovariances[k];
        if (k > 0 && selectedKnots[k] == selectedKnots[k - 1] + 2) {
            covariances[selectedKnots[k] - 1] = 0.5 * (selectedCovariances[k - 1] + selectedCovariances[k]);
        }
    }
    return covariances;
}

/// Returns the weighted mean over the fits of d dᵀ, where d is the displacement from the best fit.
std::vector<Eigen::Matrix3d> spreadOfFits(const std::vector<KnotPositions>& positions,
                                          const std::vector<DeformationFit>& fits, std::size_t best)
{
    std::vector<Eigen::Matrix3d> spread(positions[best].size(), Eigen::Matrix3d::Zero());
    const std::vector<double> shares = fitWeights(fits, best);
    for (std::size_t run = 0; run < fits.size(); ++run) {
        for (std::size_t k = 0; k < spread.size(); ++k) {
            const Eigen::Vector3d apart = positions[run][k] - positions[best][k];
            spread[k] += shares[run] * apart * apart.transpose();
        }
    }
    return spread;
}

double rmsInPlane(const std::vector<Eigen::Matrix3d>& spread, const std::vector<double>& weights)
{
    double sum = 0.0;
    double total = 0.0;
    for (std::size_t k = 0; k < spread.size(); ++k) {
        sum += weights[k] * (spread[k](0, 0) + spread[k](1, 1));
        total += weights[k];
    }
    return total > 0.0 ? std::sqrt(sum / total) : 0.0;
}

/// Interpolates knot values to the points of a branch by arc length.
template <class Value>
std::vector<Value> atPoints(const VesselBranch& branch, const Value* first, std::size_t count)
{
    std::vector<double> arc(branch.pointsInPatient.size(), 0.0);
    for (std::size_t i = 1; i < arc.size(); ++i) {
        arc[i] = arc[i - 1] + (branch.pointsInPatient[i] - branch.pointsInPatient[i - 1]).norm();
    }
    std::vector<Value> values;
    values.reserve(arc.size());
    for (const double passed : arc) {
        const double place = arc.back() > 0.0 ? passed / arc.back() * static_cast<double>(count - 1) : 0.0;
        const auto before = std::min(static_cast<std::size_t>(place), count - 1);
        const std::size_t after = std::min(before + 1, count - 1);
        const double share = place - static_cast<double>(before);
        values.push_back((1.0 - share) * first[before] + share * first[after]);
    }
    return values;
}

std::vector<double> seenShares(const DeformationProblem& problem, const DeformationFit& fit)
{
    std::vector<std::uint8_t> isSeen(problem.knots.size(), 0);
    for (const MotionRow& row : fit.rows()) {
        isSeen[row.knot] = 1;
    }
    std::vector<double> shares;
    for (std::size_t b = 0; b + 1 < problem.knots.firstOfBranch.size(); ++b) {
        double seen = 0.0;
        double total = 0.0;
        for (std::size_t k = problem.knots.firstOfBranch[b]; k < problem.knots.firstOfBranch[b + 1]; ++k) {
            total += problem.knots.lengthMm[k];
            seen += isSeen[k] != 0 ? problem.knots.lengthMm[k] : 0.0;
        }
        shares.push_back(total > 0.0 ? seen / total : 0.0);
    }
    return shares;
}

/// Returns the length of a motion: in the image plane for a single view, otherwise in 3-D.
double seenMotionMm(const Eigen::Vector3d& motion, const RigidTransform& pose, std::size_t viewCount)
{
    return viewCount == 1 ? (pose.rotation * motion).head<2>().norm() : motion.norm();
}

}   // namespace

KnotPositions knotPositionsInCamera(const DeformationProblem& problem, const DeformationFit& fit)
{
    const DeformedTree deformed = fit.deformedTree();
    KnotPositions positions;
    for (std::size_t k = 0; k < problem.knots.size(); ++k) {
        positions.push_back(deformed.cameraFromPatient *
                            (problem.knots.positions[k] + deformed.motionMm.col(static_cast<Eigen::Index>(k))));
    }
    return positions;
}

std::vector<double> fitWeights(const std::vector<DeformationFit>& fits, std::size_t best)
{
    std::vector<double> shares;
    double total = 0.0;
    for (const DeformationFit& run : fits) {
        shares.push_back(std::exp((run.logLikelihood() - fits[best].logLikelihood()) / fitWeightScale));
        total += shares.back();
    }
    for (double& share : shares) {
        share /= total;
    }
    return shares;
}

double covarianceInflation(const DeformationFit& fit)
{
    return std::max(1.0, fit.state().noisePx / tracingNoisePx);
}

RigidTransform fitRigidTransform(const std::vector<Eigen::Vector3d>& from, const std::vector<Eigen::Vector3d>& to,
                                 const std::vector<double>& weights)
{
    double total = 0.0;
    Eigen::Vector3d fromMean = Eigen::Vector3d::Zero();
    Eigen::Vector3d toMean = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < from.size(); ++k) {
        total += weights[k];
        fromMean += weights[k] * from[k];
        toMean += weights[k] * to[k];
    }
    fromMean /= total;
    toMean /= total;
    Eigen::Matrix3d both = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < from.size(); ++k) {
        both += weights[k] * (to[k] - toMean) * (from[k] - fromMean).transpose();
    }
    RigidTransform rigid;
    rigid.rotation = nearestRotation(both);
    rigid.translation = toMean - rigid.rotation * fromMean;
    return rigid;
}

DeformableResult rigidResult(std::span<const DeformableView> views)
{
    DeformableResult result;
    result.cameraFromPatient = views.front().rigidCameraFromPatient;
    for (const DeformableView& view : views) {
        result.viewPoses.push_back(view.rigidCameraFromPatient);
    }
    for (const VesselBranch& branch : views.front().input.tree.branches) {
        const std::size_t count = branch.pointsInPatient.size();
        BranchMotion motion;
        motion.branchId = branch.id;
        motion.displacementMm.assign(count, Eigen::Vector3d::Zero());
        motion.covariance.assign(count, Eigen::Matrix3d::Zero());
        result.branches.push_back(std::move(motion));
    }
    return result;
}

DeformableResult deformedResult(std::span<const DeformableView> views, const DeformationProblem& problem,
                                const std::vector<DeformationFit>& fits, std::size_t best)
{
    DeformableResult result = rigidResult(views);
    const DeformationFit& fit = fits[best];
    if (!fit.posterior()) {
        return result;
    }
    std::vector<KnotPositions> positions;
    for (const DeformationFit& run : fits) {
        positions.push_back(knotPositionsInCamera(problem, run));
    }
    const TreeKnots& knots = problem.knots;
    const RigidTransform pose = fitRigidTransform(knots.positions, positions[best], knots.lengthMm);
    const RigidTransform patientFromCamera = pose.inverse();
    result.cameraFromPatient = pose;
    for (std::size_t view = 0; view < views.size(); ++view) {
        result.viewPoses[view] = fit.viewFromFirst(view) * pose;
    }
    std::vector<Eigen::Vector3d> motion;
    double total = 0.0;
    for (std::size_t k = 0; k < knots.size(); ++k) {
        motion.push_back(patientFromCamera * positions[best][k] - knots.positions[k]);
        const double size = seenMotionMm(motion.back(), pose, views.size());
        result.largestMotionMm = std::max(result.largestMotionMm, size);
        result.meanMotionMm += knots.lengthMm[k] * size;
        total += knots.lengthMm[k];
    }
    result.meanMotionMm /= total;
    const std::vector<Eigen::Matrix3d> spread = spreadOfFits(positions, fits, best);
    std::vector<Eigen::Matrix3d> covariances = covariancesOf(problem, fit, positions[best]);
    const double inflation = covarianceInflation(fit);
    for (std::size_t k = 0; k < covariances.size(); ++k) {
        covariances[k] = inflation * covariances[k] + spread[k];
    }
    const std::vector<double> seen = seenShares(problem, fit);
    const std::vector<VesselBranch>& branches = views.front().input.tree.branches;
    for (std::size_t b = 0; b < branches.size(); ++b) {
        const std::size_t first = knots.firstOfBranch[b];
        const std::size_t count = knots.firstOfBranch[b + 1] - first;
        result.branches[b].displacementMm = atPoints(branches[b], &motion[first], count);
        result.branches[b].covariance = atPoints(branches[b], &covariances[first], count);
        result.branches[b].seenShare = seen[b];
        roundMotion(result.branches[b]);
    }
    result.spreadMm = rmsInPlane(spread, knots.lengthMm);
    result.placeStdMm = rmsInPlane(covariances, knots.lengthMm);
    result.rigid = rigidOffset(views.front().input.tree, problem, fits, best);
    result.explainedShare = fit.explainedShare();
    result.noisePx = fit.state().noisePx;
    return result;
}

}   // namespace angiopose::core
