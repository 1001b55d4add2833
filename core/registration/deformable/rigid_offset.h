#pragma once

#include "core/registration/deformable/bend_fit.h"
#include "core/registration/deformable/deform_vessels.h"

#include <vector>

namespace angiopose::core {

/// Where the rigid pose lies by the best of several runs, by what is known of the start pose and of the motion
/// (ALGORITHMS §11.5).
RigidOffset rigidOffset(const VesselTree& tree, const BendProblem& problem, const std::vector<BendFit>& runs,
                        std::size_t best);

}   // namespace angiopose::core
