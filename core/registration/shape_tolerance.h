#pragma once

#include "core/registration/alignment.h"

namespace core {

/// Refines a converged pose when the tree's shape is not exact (ALGORITHMS §6.10, §6.14). Stretches of the branches may
/// then be off as wholes, by offsets as large as the residuals show: the turn follows the course of the branches more
/// than their place (generalised least squares), and the shift lays the tree over the vessels. A tree without such
/// errors keeps its pose.
CentroidPose refineTolerantly(const Alignment& alignment, const StartPrior& prior, const CentroidPose& pose,
                              double scalePx);

/// What the residuals along the branches consist of.
struct ShapeErrors {
    double offsetPx = 0.0;   ///< standard deviation of the offsets of stretches, beyond what the scatter explains
    double scatterPx = 0.0;   ///< standard deviation inside the stretches
    double correlationPoints = 1.0;   ///< neighbouring points that share one scatter

    /// Of the offsets in units of the scatter; 0 where the shape is as good as exact.
    double varianceRatio() const;
};

ShapeErrors shapeErrors(const std::vector<ResidualRow>& rows);

/// Normal equations with the offset of every stretch eliminated, averaged over overlapping stretches. A ratio of 0
/// gives the plain ones.
NormalEquations tolerantEquations(const std::vector<ResidualRow>& rows, double varianceRatio);

}   // namespace core
