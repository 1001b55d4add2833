#pragma once

#include "io/vessel/line_set.h"

#include <string_view>

namespace angiopose::io {

/// Parses CSV `x,y,z[,radius][,branch][,label]` (mm, LPS), columns in any order; three columns of numbers without a
/// header are x, y, z. The rows of a branch are consecutive, in order along it.
core::Result<LineSet> parseTreeTable(std::string_view text, const std::string& path);

/// Returns whether a table with this beginning holds 3-D points: it names a column z, or has three columns of numbers
/// without a header.
bool isTreeTable(std::string_view head);

/// Returns CSV `x,y,z,radius,branch`; an unknown radius is `nan`, and the column is omitted if none is known.
std::string treeTable(const core::VesselTree& tree);

}   // namespace angiopose::io