#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/registration/pose/damped_step.h"

namespace angiopose::core {

/// Prior of DynaWeightPnP at a reference pose (ALGORITHMS §1, "prior residual"): cost λ eᵀW²e with e = log(reference⁻¹
/// pose), (rad, mm). The meaning of W = I depends on the origin of the posed frame, the X-ray source in DynaWeightPnP.
struct PosePrior {
    RigidTransform reference;
    Vector6d weights = Vector6d::Ones();   ///< diagonal of W
    double strength = 0.0;   ///< weight λ; 0 disables the prior
};

/// Returns the residual e (rad, mm).
Vector6d priorResidual(const PosePrior& prior, const RigidTransform& pose);

/// Returns ∂e/∂ξ for pose ← exp(ξ) pose, exactly: J_r⁻¹(e) Ad(pose⁻¹).
Matrix6d priorJacobian(const PosePrior& prior, const RigidTransform& pose);

/// Returns λ eᵀW²e.
double priorCost(const PosePrior& prior, const RigidTransform& pose);

/// Adds the linearized prior for pose ← exp(ξ) pose.
void addPrior(const PosePrior& prior, const RigidTransform& pose, NormalEquations& equations);

}   // namespace angiopose::core
