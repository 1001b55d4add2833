#pragma once

#include "core/geometry/camera_spread.h"
#include "core/registration/alignment/alignment.h"

namespace angiopose::core {

/// Refines a converged pose when the tree's shape is not exact (ALGORITHMS §6.10, §6.14). The vessels may then be bent
/// smoothly, by as much as the residuals show: the turn follows the course of the branches more than their place
/// (generalised least squares, see ShapeField), and the shift lays the tree over the vessels. A tree without such
/// errors keeps its pose.
CentroidPose refineTolerantly(const Alignment& alignment, const StartPrior& prior, const CentroidPose& pose,
                              double scalePx);

/// Standard deviation of the field that the residuals at a pose show, px; 0 where whole stretches lie on their vessels.
double likelyOffsetOf(const Alignment& alignment, const CentroidPose& pose);

/// What the residuals at a pose tell about the pose, without the prior: normal equations in units of information.
NormalEquations tolerantInformation(const Alignment& alignment, const StartPrior& prior, const CentroidPose& pose);

/// The same about the pose and the camera, which may err by `spread`; that prior is not in the equations either.
CameraEquations tolerantInformation(const Alignment& alignment, const StartPrior& prior, const CentroidPose& pose,
                                    const CameraSpread& spread);

}   // namespace angiopose::core