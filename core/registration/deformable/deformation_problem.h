#pragma once

#include "core/registration/deformable/deform_vessels.h"
#include "core/registration/deformable/deformation_fit.h"

#include <span>

namespace angiopose::core {

/// Builds the deformation problem for these views; fails if a view or an option is unusable.
Result<DeformationProblem> makeDeformationProblem(std::span<const DeformableView> views,
                                                  const DeformableOptions& options);

/// Replaces the image or the rigid pose, but not the tree, its knots and the kernel. Changes nothing on failure.
Status replaceView(DeformationProblem& problem, const DeformableView& view, const DeformableOptions& options);

}   // namespace angiopose::core
