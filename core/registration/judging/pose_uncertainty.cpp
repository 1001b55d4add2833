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

/// Inverse among the free steps, zero across them.
Matrix6d inverseAmong(const StepBasis& free, const Matrix6d& information)
{
    using Reduced = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
    const Reduced reduced = free.transpose() * information * free;
    return free * reduced.inverse() * free.transpose();
}

/// Carries steps about one place of the body to steps about another, `armInCamera` away.
Matrix6d aboutOther(const Eigen::Vector3d& armInCamera)
{
    Matrix6d carry = Matrix6d::Identity();
    carry.bottomLeftCorner<3, 3>() = -skew(armInCamera);
    return carry;
}

}   // namespace

PoseUncertainty poseUncertainty(const RegistrationProblem& problem, const TargetLines& target,
                                const RigidTransform& cameraFromPatient, const StartPrior& prior)
{
    const CentroidPose pose = aboutCentroid(cameraFromPatient, problem.tree.centroid);
    return poseUncertainty(problem, imageInformation(problem, target, pose, prior), prior, pose);
}

PoseUncertainty poseUncertainty(const RegistrationProblem& problem, const Matrix6d& imageInformation,
                                const StartPrior& prior, const CentroidPose& pose)
{
    const StepBasis free = prior.freedom.freeSteps(pose);
    const Matrix6d priorInformation = prior.informationAt(pose);
    const Vector6d priorStd = prior.std();
    const Matrix6d carry = aboutOther(pose.rotation * (problem.wholeTreeCentroid - problem.tree.centroid));
    PoseUncertainty uncertainty;
    uncertainty.covariance = carry * inverseAmong(free, imageInformation + priorInformation) * carry.transpose();
    // A hint of prior keeps the inverse finite where the image tells nothing.
    const Matrix6d imageAlone = inverseAmong(free, imageInformation + 1e-6 * priorInformation);
    for (int k = 0; k < 6; ++k) {
        uncertainty.observed[static_cast<std::size_t>(k)] =
            prior.freedom.isLocked(k) || std::sqrt(imageAlone(k, k)) < 0.5 * priorStd[k];
    }
    const Vector6d std = uncertainty.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    uncertainty.rotationDeg = std.head<3>() * 180.0 / std::numbers::pi;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> lateral(uncertainty.covariance.block<2, 2>(3, 3));
    uncertainty.inPlaneMm = std::sqrt(std::max(0.0, lateral.eigenvalues()[1]));
    uncertainty.depthMm = std[5];

    Vector6d inMm = Vector6d::Ones();
    inMm.head<3>().setConstant(problem.tree.spreadMm);
    const Eigen::SelfAdjointEigenSolver<Matrix6d> axes(inMm.asDiagonal() * uncertainty.covariance * inMm.asDiagonal());
    uncertainty.weakestDirection = axes.eigenvectors().col(5);
    return uncertainty;
}

Matrix6d poseInformation(const RegistrationProblem& problem, const TargetLines& target, const CentroidPose& pose,
                         const StartPrior& prior)
{
    return imageInformation(problem, target, pose, prior) + prior.informationAt(pose);
}

}   // namespace angiopose::core