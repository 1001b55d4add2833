#pragma once

#include "io/vessel/line_set.h"

#include <string_view>

namespace angiopose::io {

/// CSV `x,y,z[,radius][,branch][,label]` (mm, LPS), columns in any order; three bare columns of numbers are x, y, z.
/// Rows of one branch follow each other along it.
core::Result<LineSet> parseTreeTable(std::string_view text, const std::string& path);

/// Whether a table that begins so is one of points in space: it names a column z, or has three bare columns of numbers.
bool isTreeTable(std::string_view head);

/// CSV `x,y,z,radius,branch`; `nan` radius where unknown, the column left out when none is known.
std::string treeTable(const core::VesselTree& tree);

}   // namespace angiopose::io