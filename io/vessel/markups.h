#pragma once

#include "io/vessel/line_set.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Parses the curves of a Slicer markups file (`.mrk.json`) as one line per curve, converted to LPS.
core::Result<LineSet> parseMarkups(std::string_view json, const std::string& path);

/// Returns the tree as Slicer markups, one open curve per branch, in LPS; the format cannot store radii.
std::string markupsText(const core::VesselTree& tree);

}   // namespace angiopose::io
