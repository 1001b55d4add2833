#include "core/registration/pose/pose_prior.h"

namespace angiopose::core {

Vector6d priorResidual(const PosePrior& prior, const RigidTransform& pose)
{
    return logSe3(prior.reference.inverse() * pose);
}

Matrix6d priorJacobian(const PosePrior& prior, const RigidTransform& pose)
{
    return inverseRightJacobianSe3(priorResidual(prior, pose)) * adjoint(pose.inverse());
}

double priorCost(const PosePrior& prior, const RigidTransform& pose)
{
    if (prior.strength == 0.0) {
        return 0.0;
    }
    return prior.strength * prior.weights.cwiseProduct(priorResidual(prior, pose)).squaredNorm();
}

void addPrior(const PosePrior& prior, const RigidTransform& pose, NormalEquations& equations)
{
    if (prior.strength == 0.0) {
        return;
    }
    const Matrix6d weighted = prior.weights.asDiagonal() * priorJacobian(prior, pose);
    const Vector6d residual = prior.weights.cwiseProduct(priorResidual(prior, pose));
    equations.hessian += prior.strength * weighted.transpose() * weighted;
    equations.gradient += prior.strength * weighted.transpose() * residual;
}

}   // namespace angiopose::core
