#pragma once

#include "core/registration/alignment/alignment.h"

namespace angiopose::core {

/// What the residuals along the branches consist of.
struct ResidualNoise {
    double scatterPx = 0.0;   ///< standard deviation inside short stretches
    double correlationPoints = 1.0;   ///< neighbouring points that share one scatter
    double offsetPx = 0.0;   ///< standard deviation of whole stretches, beyond what the scatter explains

    /// Nearest partners flatter the residuals: without this the errors of simulated registrations were 1.25 times as
    /// large, squared, as their covariance said.
    static constexpr double nearestPartnerGain = 1.25;

    /// Of one row, counted as if its neighbours were independent (ALGORITHMS §6.10: l_c σ̂²); px².
    double rowVariance() const { return nearestPartnerGain * scatterPx * scatterPx * correlationPoints; }
    /// Stretches lie beside the vessels as wholes, by more than sampling (about 0.1 px) explains.
    bool hasOffsets() const { return offsetPx >= 0.1; }
};

ResidualNoise residualNoise(const std::vector<ResidualRow>& rows);

}   // namespace angiopose::core