#pragma once

#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// Returns the tree with an additional branch that gets a new id. End pieces inside other branches are removed, and
/// each such end is connected to the centerline of the branch that contains it; the branch begins at the one of the
/// lower generation and belongs to the next generation. Fails if no part of the branch lies outside the others.
Result<VesselTree> attachBranch(const VesselTree& tree, VesselBranch branch);

}   // namespace angiopose::core
