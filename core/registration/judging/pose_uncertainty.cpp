#include "core/registration/judging/pose_uncertainty.h"

#include "core/registration/alignment/alignment.h"
#include "core/registration/alignment/shape_tolerance.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace core {

PoseUncertainty poseUncertainty(const RegistrationProblem& problem, const TargetLines& target,
                                const RigidTransform& cameraFromPatient, const StartPrior& prior)
{
    const CentroidPose pose = aboutCentroid(cameraFromPatient, problem.tree.centroid);
    const Alignment alignment(alignmentPoints(problem.tree), problem.camera, target);
    return poseUncertainty(tolerantInformation(alignment, prior, pose).hessian, prior, problem.tree.spreadMm);
}

PoseUncertainty poseUncertainty(const Matrix6d& data, const StartPrior& prior, double spreadMm)
{
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
    inMm.head<3>().setConstant(spreadMm);
    const Eigen::SelfAdjointEigenSolver<Matrix6d> axes(inMm.asDiagonal() * uncertainty.covariance * inMm.asDiagonal());
    uncertainty.weakestDirection = axes.eigenvectors().col(5);
    return uncertainty;
}

}   // namespace core
