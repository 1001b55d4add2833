#include "core/registration/judging/pose_uncertainty.h"

#include "core/registration/alignment/alignment.h"
#include "core/registration/alignment/alignment_points.h"
#include "core/registration/alignment/camera_influence.h"
#include "core/registration/alignment/shape_tolerance.h"
#include "core/support/symmetric.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::core {

namespace {

Alignment informativeAlignment(const RegistrationProblem& problem, const TargetLines& target, const CentroidPose& pose)
{
    const double depthMm = std::max(minProjectableDepthMm, pose.centroidInCamera.z());
    return {informativePoints(problem.tree, millimetersPerPixel(problem.camera, depthMm)), problem.camera, target};
}

/// Returns the inverse restricted to the free steps, with zeros for the locked ones.
Matrix6d inverseAmong(const StepBasis& free, const Matrix6d& information)
{
    const SmallMatrix reduced = free.transpose() * information * free;
    return free * inverseOf(reduced) * free.transpose();
}

/// Returns the matrix that converts steps about one point of the body to steps about another point, at the offset
/// `leverArmInCamera`.
Matrix6d aboutOther(const Eigen::Vector3d& leverArmInCamera)
{
    Matrix6d carry = Matrix6d::Identity();
    carry.bottomLeftCorner<3, 3>() = -skew(leverArmInCamera);
    return carry;
}

}   // namespace

UncertaintyEstimate estimateUncertainty(const RegistrationProblem& problem, const TargetLines& target,
                                        const RigidTransform& cameraFromPatient, const InitialPosePrior& prior)
{
    const CentroidPose pose = aboutCentroid(cameraFromPatient, problem.tree.centroid);
    const Alignment alignment = informativeAlignment(problem, target, pose);
    if (problem.cameraUncertainty.isExact()) {
        const Matrix6d information = tolerantInformation(alignment, prior, pose).hessian;
        return {poseUncertainty(problem, information, Matrix6d::Zero(), prior, pose), std::nullopt};
    }
    const CameraEquations image = tolerantInformation(alignment, prior, pose, problem.cameraUncertainty);
    NormalEquations start;
    prior.add(pose, 1.0, start);
    StackedEquations all{image.hessian, image.gradient};
    all.hessian.topLeftCorner<6, 6>() += start.hessian;
    all.gradient.head<6>() += start.gradient;
    const CameraInfluence influence(all, prior.freedom.freeSteps(pose), {&problem.cameraUncertainty, 1});
    return {poseUncertainty(problem, image.hessian.topLeftCorner<6, 6>(), influence.poseCovariance(), prior, pose),
            influence.evidence(0)};
}

PoseUncertainty poseUncertainty(const RegistrationProblem& problem, const Matrix6d& imageInformation,
                                const Matrix6d& cameraCovariance, const InitialPosePrior& prior,
                                const CentroidPose& pose)
{
    const StepBasis free = prior.freedom.freeSteps(pose);
    const Matrix6d priorInformation = prior.informationAt(pose);
    const Vector6d priorStd = prior.std();
    const Matrix6d carry = aboutOther(pose.rotation * (problem.wholeTreeCentroid - problem.tree.centroid));
    PoseUncertainty uncertainty;
    uncertainty.covariance = carry * cameraCovariance * carry.transpose();
    // A weak prior keeps the inverse finite where the image carries no information.
    const Matrix6d imageAlone = inverseAmong(free, imageInformation + 1e-6 * priorInformation);
    for (int k = 0; k < 6; ++k) {
        uncertainty.observed[static_cast<std::size_t>(k)] =
            prior.freedom.isLocked(k) || std::sqrt(imageAlone(k, k)) < 0.5 * priorStd[k];
    }
    const Matrix6d ofImage = inverseAmong(free, imageInformation + priorInformation);
    replaceImageCovariance(uncertainty, carry * ofImage * carry.transpose(), problem.tree.spreadMm);
    return uncertainty;
}

void replaceImageCovariance(PoseUncertainty& uncertainty, const Matrix6d& covariance, double spreadMm)
{
    uncertainty.covariance += covariance - uncertainty.imageCovariance;
    uncertainty.imageCovariance = covariance;
    const PoseSigmas sigmas = sigmasOf(uncertainty.covariance);
    uncertainty.rotationDeg = sigmas.rotationDeg;
    uncertainty.inPlaneMm = sigmas.inPlaneMm;
    uncertainty.depthMm = sigmas.depthMm;

    Vector6d inMm = Vector6d::Ones();
    inMm.head<3>().setConstant(spreadMm);
    const Matrix6d covarianceInMm = inMm.asDiagonal() * covariance * inMm.asDiagonal();
    uncertainty.weakestDirection = eigenDecomposition(covarianceInMm).directions.col(5);
}

PoseSigmas sigmasOf(const Matrix6d& covariance)
{
    const Vector6d std = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    const EigenDecomposition<2> lateral = eigenDecomposition(Eigen::Matrix2d(covariance.block<2, 2>(3, 3)));
    return {std.head<3>() * 180.0 / std::numbers::pi, std::sqrt(std::max(0.0, lateral.values[1])), std[5]};
}

Matrix6d poseInformation(const RegistrationProblem& problem, const TargetLines& target, const CentroidPose& pose,
                         const InitialPosePrior& prior)
{
    return tolerantInformation(informativeAlignment(problem, target, pose), prior, pose).hessian +
           prior.informationAt(pose);
}

}   // namespace angiopose::core
