#pragma once

#include "core/vessel/vessel_tree.h"

#include <string>

namespace angiopose::io {

/// The tree as a VTP file: one poly-line per branch, `Radius` per point, `GroupIds` and `Name` per line, LPS noted.
/// Doubles are stored as they are.
std::string vtpText(const core::VesselTree& tree);

}   // namespace angiopose::io