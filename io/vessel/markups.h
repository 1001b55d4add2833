#pragma once

#include "io/vessel/line_set.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Curves of a Slicer markups file (`.mrk.json`), one line each, turned to LPS.
core::Result<LineSet> parseMarkups(std::string_view json, const std::string& path);

/// The tree as Slicer markups, one open curve per branch, LPS; radii have no place there.
std::string markupsText(const core::VesselTree& tree);

}   // namespace angiopose::io