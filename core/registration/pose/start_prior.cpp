#include "core/registration/pose/start_prior.h"

#include <numbers>

namespace angiopose::core {

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

StartPrior startPrior(const CentroidPose& start, const RegistrationOptions& options, const PoseFreedom& freedom)
{
    const double rotation = options.priorRotationDeg * std::numbers::pi / 180.0;
    StartPrior prior{start, {}, freedom};
    prior.std << rotation, rotation, rotation, options.priorLateralMm, options.priorLateralMm, options.priorDepthMm;
    return prior;
}

}   // namespace angiopose::core