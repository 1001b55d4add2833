#pragma once

#include "core/registration/alignment.h"

namespace core {

/// Refines a converged pose when the tree's shape is not exact (ALGORITHMS §6.10, §6.14). Stretches of the branches may
/// then be off as wholes, by offsets as large as the residuals show: the turn follows the course of the branches more
/// than their place (generalised least squares), and the shift lays the tree over the vessels. A tree without such
/// errors keeps its pose.
CentroidPose refineTolerantly(const Alignment& alignment, const StartPrior& prior, const CentroidPose& pose,
                              double scalePx);

/// Variance of the stretches' offsets in units of the variance inside them; 0 where the shape is as good as exact.
double offsetVarianceRatio(const std::vector<ResidualRow>& rows);

/// Normal equations with the offset of every stretch eliminated, averaged over overlapping stretches.
NormalEquations tolerantEquations(const std::vector<ResidualRow>& rows, double varianceRatio);

}   // namespace core
