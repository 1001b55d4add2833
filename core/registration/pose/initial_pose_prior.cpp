#include "core/registration/pose/initial_pose_prior.h"

#include "core/support/symmetric.h"

#include <numbers>

namespace angiopose::core {
namespace {

/// Returns d stepBetween(start, retract(pose, x)) / dx at x = 0, given the step from `start` to the pose.
Matrix6d stepJacobian(const Vector6d& step)
{
    Matrix6d growth = Matrix6d::Identity();
    growth.topLeftCorner<3, 3>() = inverseLeftJacobianSo3(step.head<3>());
    return growth;
}

}   // namespace

Vector6d InitialPosePrior::std() const
{
    return inverseOf(information).diagonal().cwiseSqrt();
}

double InitialPosePrior::cost(const CentroidPose& pose) const
{
    const Vector6d step = stepBetween(start, pose);
    return step.dot(information * step);
}

void InitialPosePrior::add(const CentroidPose& pose, double variance, NormalEquations& equations) const
{
    const Vector6d step = stepBetween(start, pose);
    const Matrix6d growth = stepJacobian(step);
    const Matrix6d weighted = variance * growth.transpose() * information;
    equations.hessian += weighted * growth;
    equations.gradient += weighted * step;
}

Matrix6d InitialPosePrior::informationAt(const CentroidPose& pose) const
{
    const Matrix6d growth = stepJacobian(stepBetween(start, pose));
    return growth.transpose() * information * growth;
}

InitialPosePrior independentPrior(const CentroidPose& start, const Vector6d& std, const PoseFreedom& freedom)
{
    return {start, Vector6d(std.cwiseAbs2().cwiseInverse()).asDiagonal(), freedom};
}

InitialPosePrior initialPosePrior(const CentroidPose& start, const RegistrationOptions& options,
                                  const PoseFreedom& freedom)
{
    const bool isWire = options.method == "wire";
    const double rotationDeg = isWire ? options.wire.rotationDeg : options.angiopose.priorRotationDeg;
    const double lateralMm = isWire ? options.wire.lateralMm : options.angiopose.priorLateralMm;
    const double depthMm = isWire ? options.wire.depthMm : options.angiopose.priorDepthMm;
    const double rotation = rotationDeg * std::numbers::pi / 180.0;
    Vector6d std;
    std << rotation, rotation, rotation, lateralMm, lateralMm, depthMm;
    return independentPrior(start, std, freedom);
}

}   // namespace angiopose::core
