#pragma once

#include "core/registration/deformable/deform_vessels.h"
#include "core/registration/deformable/deformation_fit.h"

#include <vector>

namespace angiopose::core {

/// Returns the offset of the rigid pose from the best of several fits, using the priors of the initial pose and of the
/// motion (ALGORITHMS §11.5).
RigidOffset rigidOffset(const VesselTree& tree, const DeformationProblem& problem,
                        const std::vector<DeformationFit>& fits, std::size_t best);

}   // namespace angiopose::core
