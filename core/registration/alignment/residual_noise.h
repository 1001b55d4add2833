#pragma once

#include "core/registration/alignment/alignment.h"

namespace angiopose::core {

/// Noise components of the residuals along the branches.
struct ResidualNoise {
    double scatterPx = 0.0;   ///< standard deviation within short stretches
    double correlationPoints = 1.0;   ///< correlation length of the scatter, points
    double offsetPx = 0.0;   ///< standard deviation of the stretch offsets, in excess of the scatter

    /// Correction for nearest-point matching, which biases residuals toward zero: without this factor, the squared
    /// errors of simulated registrations were 1.25 times as large as their covariance predicted.
    static constexpr double nearestPointBias = 1.25;

    /// Returns the variance of one row if rows are treated as independent (ALGORITHMS §6.10: l_c σ̂²); px².
    double rowVariance() const { return nearestPointBias * scatterPx * scatterPx * correlationPoints; }
    /// Whether whole stretches are offset from the vessels by more than sampling explains (about 0.1 px).
    bool hasOffsets() const { return offsetPx >= 0.1; }
};

ResidualNoise residualNoise(const std::vector<ResidualRow>& rows);

}   // namespace angiopose::core
