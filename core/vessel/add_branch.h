#pragma once

#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// The tree with a further branch, its id new. What of its ends runs inside other branches is left out, and each such
/// end is led to the axis of the branch it lies in; it begins at the one of the lower generation, and counts as of the
/// next. Fails where nothing of it lies outside.
Result<VesselTree> withBranch(const VesselTree& tree, VesselBranch branch);

}   // namespace angiopose::core
