#pragma once

#include "core/registration/deformable/deform_vessels.h"
#include "core/registration/deformable/deformation_fit.h"

#include <span>

namespace angiopose::core {

/// What the fit of these views starts from; fails where views or options cannot be used.
Result<DeformationProblem> makeDeformationProblem(std::span<const DeformableView> views,
                                                  const DeformableOptions& options);

/// The same tree in another image, or from another rigid pose: knots and kernel stay. As it was where that fails.
Status lookElsewhere(DeformationProblem& problem, const DeformableView& view, const DeformableOptions& options);

}   // namespace angiopose::core
