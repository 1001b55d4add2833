#pragma once

#include "core/registration/options/registration_options.h"
#include "core/registration/pose/pose_freedom.h"

namespace angiopose::core {

/// Gaussian prior on the step from the initial pose, about the centroid (ALGORITHMS §6.6 a).
struct InitialPosePrior {
    CentroidPose start;
    Matrix6d information = Matrix6d::Identity();   ///< inverse covariance of the step (rad, mm)
    PoseFreedom freedom{};   ///< locked parameters have no error

    /// Returns the 1-σ error of each component of the step.
    Vector6d std() const;

    /// Returns sᵀ Λ s for the step s from the initial pose to `pose`, with Λ the prior's information.
    double cost(const CentroidPose& pose) const;

    /// Adds the prior cost, scaled by `variance`, to equations for steps about `pose`.
    void add(const CentroidPose& pose, double variance, NormalEquations& equations) const;

    /// Returns the prior's information for steps about `pose`.
    Matrix6d informationAt(const CentroidPose& pose) const;
};

/// Returns a prior with independent errors of these standard deviations (rad, mm).
InitialPosePrior independentPrior(const CentroidPose& start, const Vector6d& std, const PoseFreedom& freedom = {});

/// Returns the prior with the standard deviations given in the options.
InitialPosePrior initialPosePrior(const CentroidPose& start, const RegistrationOptions& options,
                                  const PoseFreedom& freedom = {});

}   // namespace angiopose::core
