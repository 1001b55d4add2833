#pragma once

#include "core/simulation/grow_tree.h"

namespace angiopose::core {

/// A given tree as if it had been grown: rooted (rootedAt) at the thickest end of any branch, every branch but the
/// trunk taken to leave the nearest point of the branches before it. Radii that are not known follow Murray's law from
/// `rootRadiusMm` (murrayRadii). Pieces that do not connect count as fed by the nearest branch.
GrownTree withTakeoffs(const VesselTree& tree, double rootRadiusMm);

/// Edge length of the box around the tree, the longest.
double extentMm(const VesselTree& tree);

}   // namespace angiopose::core
