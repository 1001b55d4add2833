#pragma once

#include "core/registration/options/registration_options.h"
#include "core/registration/pose/pose_freedom.h"

namespace angiopose::core {

/// Prior of the initial pose (ALGORITHMS §6.6 a): Gaussian errors of the step from it, about the centroid.
struct StartPrior {
    CentroidPose start;
    Matrix6d information = Matrix6d::Identity();   ///< inverse covariance of the step (rad, mm)
    PoseFreedom freedom{};   ///< locked parameters are exact

    /// 1-σ of each component of the step.
    Vector6d std() const;

    /// sᵀ Λ s of the step s from the initial pose to this pose.
    double cost(const CentroidPose& pose) const;

    /// Adds `variance` · cost for steps about `pose`.
    void add(const CentroidPose& pose, double variance, NormalEquations& equations) const;

    /// Information about steps about `pose`.
    Matrix6d informationAt(const CentroidPose& pose) const;
};

/// Independent errors with these standard deviations (rad, mm).
StartPrior independentPrior(const CentroidPose& start, const Vector6d& std, const PoseFreedom& freedom = {});

/// Prior with the standard deviations from the options.
StartPrior startPrior(const CentroidPose& start, const RegistrationOptions& options, const PoseFreedom& freedom = {});

}   // namespace angiopose::core