#include "core/registration/pose/centroid_pose.h"

#include <numbers>

namespace core {

CentroidPose aboutCentroid(const RigidTransform& cameraFromPatient, const Eigen::Vector3d& centroidInPatient)
{
    return {cameraFromPatient.rotation, cameraFromPatient * centroidInPatient};
}

RigidTransform cameraFromPatient(const CentroidPose& pose, const Eigen::Vector3d& centroidInPatient)
{
    return {pose.rotation, pose.centroidInCamera - pose.rotation * centroidInPatient};
}

CentroidPose moved(const CentroidPose& pose, const Vector6d& step)
{
    return {expSo3(step.head<3>()) * pose.rotation, pose.centroidInCamera + step.tail<3>()};
}

Vector6d stepBetween(const CentroidPose& from, const CentroidPose& to)
{
    Vector6d step;
    step << logSo3(to.rotation * from.rotation.transpose()), to.centroidInCamera - from.centroidInCamera;
    return step;
}

double StartPrior::cost(const CentroidPose& pose) const
{
    return stepBetween(start, pose).cwiseQuotient(std).squaredNorm();
}

void StartPrior::add(const CentroidPose& pose, double variance, NormalEquations& equations) const
{
    // All three angles share one σ, so the gradient of |log R|² needs no Jacobian: J_lᵀ⁻¹(θ) θ = θ.
    const Vector6d weight = variance * std.cwiseAbs2().cwiseInverse();
    equations.hessian.diagonal() += weight;
    equations.gradient += weight.cwiseProduct(stepBetween(start, pose));
}

StartPrior startPrior(const CentroidPose& start, const RegistrationOptions& options)
{
    const double rotation = options.priorRotationDeg * std::numbers::pi / 180.0;
    StartPrior prior{start, {}};
    prior.std << rotation, rotation, rotation, options.priorLateralMm, options.priorLateralMm, options.priorDepthMm;
    return prior;
}

}   // namespace core
