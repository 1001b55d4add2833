#pragma once

#include "core/registration/pose/pose_freedom.h"
#include "core/registration/registration_options.h"

namespace angiopose::core {

/// How far the start pose may be trusted (ALGORITHMS §6.6 a): independent normal errors about the centroid.
struct StartPrior {
    CentroidPose start;
    Vector6d std = Vector6d::Ones();   ///< rad, mm
    PoseFreedom freedom{};   ///< what is locked is certain

    /// Σ ((θ_k − θ_k0)/σ_k)².
    double cost(const CentroidPose& pose) const;

    /// Adds `variance` · cost for steps about `pose`.
    void add(const CentroidPose& pose, double variance, NormalEquations& equations) const;
};

StartPrior startPrior(const CentroidPose& start, const RegistrationOptions& options, const PoseFreedom& freedom = {});

}   // namespace angiopose::core