#pragma once

#include "core/vessel/vessel_tree.h"

#include <string>

namespace angiopose::io {

/// Returns the tree as a VTP file that states LPS: one polyline per branch, with `Radius` for each point, and
/// `GroupIds` and `Name` for each line. Doubles are stored exactly.
std::string vtpText(const core::VesselTree& tree);

}   // namespace angiopose::io
