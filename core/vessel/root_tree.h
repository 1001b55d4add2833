#pragma once

#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// The tree seen from the branch end that is nearest to `rootInPatient`: every branch runs away from the root, its
/// generation counts the branches on the way there, and parents come before their children. Ids and names stay; where
/// the way leads into the middle of a branch, that is parted, and the part that ran towards the junction keeps the id.
/// Pieces that do not connect (within `touchingMm`) follow, each from its own thickest end.
VesselTree rootedAt(const VesselTree& tree, const Eigen::Vector3d& rootInPatient);

}   // namespace angiopose::core