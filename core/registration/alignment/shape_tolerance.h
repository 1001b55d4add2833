#pragma once

#include "core/geometry/camera_uncertainty.h"
#include "core/registration/alignment/alignment.h"

namespace angiopose::core {

/// Refines a converged pose of a tree whose shape is inexact (ALGORITHMS §6.10, §6.14). The model allows smooth
/// deformation as large as the residuals show: the rotation then depends more on the direction of the branches than on
/// their position (generalized least squares, see ShapeField), and the shift aligns the tree with the vessels. A tree
/// without shape errors keeps its pose.
CentroidPose refineWithShapeErrors(const Alignment& alignment, const InitialPosePrior& prior, const CentroidPose& pose,
                                   double scalePx);

/// Returns the standard deviation of the deformation field estimated from the residuals at a pose, px; 0 if whole
/// stretches match their vessels.
double estimateOffset(const Alignment& alignment, const CentroidPose& pose);

/// Returns the information about the pose from the residuals at that pose, excluding the prior, as normal equations in
/// units of information.
NormalEquations tolerantInformation(const Alignment& alignment, const InitialPosePrior& prior,
                                    const CentroidPose& pose);

/// Returns the information about pose and camera, assuming camera errors with standard deviations `spread`; the
/// equations include neither prior.
CameraEquations tolerantInformation(const Alignment& alignment, const InitialPosePrior& prior, const CentroidPose& pose,
                                    const CameraUncertainty& spread);

}   // namespace angiopose::core
