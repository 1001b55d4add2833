#pragma once

#include "core/vessel/vessel_tree.h"

#include <string>

namespace angiopose::io {

/// Returns the tree as a VTP file: one polyline per branch, `Radius` per point, `GroupIds` and `Name` per line, marked
/// as LPS. Doubles are stored exactly.
std::string vtpText(const core::VesselTree& tree);

}   // namespace angiopose::io