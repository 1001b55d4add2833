#include "core/registration/pose_uncertainty.h"

#include "core/registration/alignment.h"
#include "core/support/quantile.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace core {
namespace {

constexpr double matchLimitPx = 6.0;   // farther points belong to no traced vessel
constexpr double madToStd = 1.4826;
constexpr double minStdPx = 0.02;   // sampling of the curves: no fit is better than this
constexpr int maxLag = 40;
constexpr double insignificantCorrelation = 0.05;
constexpr double scaleFactor = 3.0;   // Welsch scale at which Gaussian residuals keep nearly all their weight

/// Sum of products of residuals `lag` points apart on one branch, and how many there are.
struct LagSum {
    double sum = 0.0;
    int count = 0;
};

LagSum lagSum(const TreeSamples& tree, const std::vector<double>& residuals, std::size_t lag)
{
    LagSum result;
    for (std::size_t i = lag; i < residuals.size(); ++i) {
        const double product = residuals[i] * residuals[i - lag];
        if (tree.branchIndex[i] == tree.branchIndex[i - lag] && std::isfinite(product)) {
            result.sum += product;
            ++result.count;
        }
    }
    return result;
}

/// 1 + 2 Σ ρ_k up to the first lag that no longer correlates.
double correlationPoints(const TreeSamples& tree, const std::vector<double>& residuals)
{
    const LagSum variance = lagSum(tree, residuals, 0);
    double length = 1.0;
    for (int lag = 1; lag <= maxLag && variance.sum > 0.0; ++lag) {
        const LagSum covariance = lagSum(tree, residuals, static_cast<std::size_t>(lag));
        if (covariance.count == 0) {
            break;
        }
        const double correlation = covariance.sum / covariance.count / (variance.sum / variance.count);
        if (correlation < insignificantCorrelation) {
            break;
        }
        length += 2.0 * correlation;
    }
    return length;
}

}   // namespace

ResidualNoise residualNoise(const TreeSamples& tree, const std::vector<double>& residualsPx)
{
    std::vector<double> sizes;
    for (const double residual : residualsPx) {
        if (std::isfinite(residual)) {
            sizes.push_back(std::abs(residual));
        }
    }
    ResidualNoise noise;
    noise.pointCount = static_cast<int>(sizes.size());
    noise.stdPx = sizes.empty() ? matchLimitPx : std::max(minStdPx, madToStd * quantile(std::move(sizes), 0.5));
    noise.correlationPoints = correlationPoints(tree, residualsPx);
    return noise;
}

PoseUncertainty poseUncertainty(const RegistrationProblem& problem, const TargetLines& target,
                                const RigidTransform& cameraFromPatient, const StartPrior& prior)
{
    const CentroidPose pose = aboutCentroid(cameraFromPatient, problem.tree.centroid);
    const Alignment alignment(alignmentPoints(problem.tree), problem.camera, target);
    std::vector<double> residuals;
    alignment.collectResiduals(pose, matchLimitPx, residuals);
    const ResidualNoise noise = residualNoise(problem.tree, residuals);

    const Agreement agreement = alignment.look(pose, std::max(1.0, scaleFactor * noise.stdPx));
    const double variance = noise.stdPx * noise.stdPx * noise.correlationPoints;
    const Matrix6d data = Matrix6d(agreement.equations.hessian.selfadjointView<Eigen::Lower>()) / variance;
    const Vector6d priorInformation = prior.std.cwiseAbs2().cwiseInverse();

    PoseUncertainty uncertainty;
    uncertainty.covariance = (data + Matrix6d(priorInformation.asDiagonal())).inverse();
    // A hint of prior keeps the inverse finite where the image tells nothing.
    const Matrix6d imageAlone = (data + 1e-6 * Matrix6d(priorInformation.asDiagonal())).inverse();
    for (int k = 0; k < 6; ++k) {
        uncertainty.observed[static_cast<std::size_t>(k)] = std::sqrt(imageAlone(k, k)) < 0.5 * prior.std[k];
    }
    const Vector6d std = uncertainty.covariance.diagonal().cwiseSqrt();
    uncertainty.rotationDeg = std.head<3>() * 180.0 / std::numbers::pi;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> lateral(uncertainty.covariance.block<2, 2>(3, 3));
    uncertainty.inPlaneMm = std::sqrt(lateral.eigenvalues()[1]);
    uncertainty.depthMm = std[5];

    Vector6d inMm = Vector6d::Ones();
    inMm.head<3>().setConstant(problem.tree.spreadMm);
    const Eigen::SelfAdjointEigenSolver<Matrix6d> axes(inMm.asDiagonal() * uncertainty.covariance * inMm.asDiagonal());
    uncertainty.weakestDirection = axes.eigenvectors().col(5);
    return uncertainty;
}

}   // namespace core
