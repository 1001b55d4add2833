#include "core/registration/judging/pose_uncertainty.h"

#include "core/registration/alignment/alignment.h"
#include "core/registration/alignment/shape_tolerance.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::core {

namespace {

Matrix6d imageInformation(const RegistrationProblem& problem, const TargetLines& target, const CentroidPose& pose,
                          const StartPrior& prior)
{
    const double depthMm = std::max(minProjectableDepthMm, pose.centroidInCamera.z());
    const Alignment alignment(tellingPoints(problem.tree, millimetresPerPixel(problem.camera, depthMm)), problem.camera,
                              target);
    return tolerantInformation(alignment, prior, pose).hessian;
}

Matrix6d informationOf(const StartPrior& prior)
{
    return Vector6d(prior.std.cwiseAbs2().cwiseInverse()).asDiagonal();
}

/// Inverse among the free steps, zero across them.
Matrix6d inverseAmong(const StepBasis& free, const Matrix6d& information)
{
    using Reduced = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
    const Reduced reduced = free.transpose() * information * free;
    return free * reduced.inverse() * free.transpose();
}

}   // namespace

PoseUncertainty poseUncertainty(const RegistrationProblem& problem, const TargetLines& target,
                                const RigidTransform& cameraFromPatient, const StartPrior& prior)
{
    const CentroidPose pose = aboutCentroid(cameraFromPatient, problem.tree.centroid);
    return poseUncertainty(imageInformation(problem, target, pose, prior), prior, pose, problem.tree.spreadMm);
}

PoseUncertainty poseUncertainty(const Matrix6d& imageInformation, const StartPrior& prior, const CentroidPose& pose,
                                double spreadMm)
{
    const StepBasis free = prior.freedom.freeSteps(pose);
    PoseUncertainty uncertainty;
    uncertainty.covariance = inverseAmong(free, imageInformation + informationOf(prior));
    // A hint of prior keeps the inverse finite where the image tells nothing.
    const Matrix6d imageAlone = inverseAmong(free, imageInformation + 1e-6 * informationOf(prior));
    for (int k = 0; k < 6; ++k) {
        uncertainty.observed[static_cast<std::size_t>(k)] =
            prior.freedom.isLocked(k) || std::sqrt(imageAlone(k, k)) < 0.5 * prior.std[k];
    }
    const Vector6d std = uncertainty.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    uncertainty.rotationDeg = std.head<3>() * 180.0 / std::numbers::pi;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> lateral(uncertainty.covariance.block<2, 2>(3, 3));
    uncertainty.inPlaneMm = std::sqrt(std::max(0.0, lateral.eigenvalues()[1]));
    uncertainty.depthMm = std[5];

    Vector6d inMm = Vector6d::Ones();
    inMm.head<3>().setConstant(spreadMm);
    const Eigen::SelfAdjointEigenSolver<Matrix6d> axes(inMm.asDiagonal() * uncertainty.covariance * inMm.asDiagonal());
    uncertainty.weakestDirection = axes.eigenvectors().col(5);
    return uncertainty;
}

Matrix6d poseInformation(const RegistrationProblem& problem, const TargetLines& target, const CentroidPose& pose,
                         const StartPrior& prior)
{
    return imageInformation(problem, target, pose, prior) + informationOf(prior);
}

}   // namespace angiopose::core