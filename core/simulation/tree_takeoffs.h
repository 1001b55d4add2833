#pragma once

#include "core/simulation/grow_tree.h"

namespace angiopose::core {

/// Converts a given tree to a grown one: rooted (rootedAt) at the thickest end of any branch, with every branch but the
/// trunk leaving from the nearest point of the branches before it. Unknown radii follow Murray's law from
/// `rootRadiusMm` (murrayRadii). Disconnected parts are fed by the nearest branch.
GrownTree withTakeoffs(const VesselTree& tree, double rootRadiusMm);

/// Returns the longest edge of the tree's bounding box.
double extentMm(const VesselTree& tree);

}   // namespace angiopose::core
