#pragma once

#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// Roots the tree at the branch end nearest to `rootInPatient`: every branch runs away from the root, its generation
/// counts the branches on the path from the root, and parents come before their children. Ids and names are kept; a
/// branch that another one meets in the middle is split, and the part that ran toward the junction keeps the id.
/// Disconnected parts follow, each rooted at its own thickest end.
VesselTree rootTreeAt(const VesselTree& tree, const Eigen::Vector3d& rootInPatient);

}   // namespace angiopose::core
