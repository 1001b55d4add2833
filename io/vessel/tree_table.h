#pragma once

#include "io/vessel/line_set.h"

#include <string_view>

namespace angiopose::io {

/// Parses CSV `x,y,z[,radius][,branch][,label]` (mm, LPS) with columns in any order; three columns of numbers without a
/// header are x, y, z. The rows of a branch must be consecutive and in order along the branch.
core::Result<LineSet> parseTreeTable(std::string_view text, const std::string& path);

/// Returns whether a table that starts with `head` contains 3-D points: it has a column named z, or three columns of
/// numbers without a header.
bool isTreeTable(std::string_view head);

/// Returns CSV `x,y,z,radius,branch`. An unknown radius is `nan`; the column is omitted if no radius is known.
std::string treeTable(const core::VesselTree& tree);

}   // namespace angiopose::io
