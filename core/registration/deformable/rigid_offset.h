#pragma once

#include "core/registration/deformable/deform_vessels.h"
#include "core/registration/deformable/deformation_fit.h"

#include <vector>

namespace angiopose::core {

/// Offset of the rigid pose according to the best of several runs, using the priors of the initial pose and of the
/// motion (ALGORITHMS §11.5).
RigidOffset rigidOffset(const VesselTree& tree, const DeformationProblem& problem,
                        const std::vector<DeformationFit>& runs, std::size_t best);

}   // namespace angiopose::core
