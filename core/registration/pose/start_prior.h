#pragma once

#include "core/registration/options/registration_options.h"
#include "core/registration/pose/pose_freedom.h"

namespace angiopose::core {

/// How far the start pose may be trusted (ALGORITHMS §6.6 a): normal errors of the step that leads from it about the
/// centroid.
struct StartPrior {
    CentroidPose start;
    Matrix6d information = Matrix6d::Identity();   ///< inverse covariance of the step (rad, mm)
    PoseFreedom freedom{};   ///< what is locked is certain

    /// 1-σ of each component of the step.
    Vector6d std() const;

    /// sᵀ Λ s of the step s that leads from the start to the pose.
    double cost(const CentroidPose& pose) const;

    /// Adds `variance` · cost for steps about `pose`.
    void add(const CentroidPose& pose, double variance, NormalEquations& equations) const;

    /// Information about steps about `pose`.
    Matrix6d informationAt(const CentroidPose& pose) const;
};

/// Independent errors with these standard deviations (rad, mm).
StartPrior independentPrior(const CentroidPose& start, const Vector6d& std, const PoseFreedom& freedom = {});

/// The same as the options have it.
StartPrior startPrior(const CentroidPose& start, const RegistrationOptions& options, const PoseFreedom& freedom = {});

}   // namespace angiopose::core