#pragma once

#include "io/vessel/line_set.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Parses SWC rows `id type x y z radius parent` as segments between points.
core::Result<LineSet> parseSwc(std::string_view text, const std::string& path);

/// Returns a tree as SWC rows, in mm, with type 5 where branches meet and otherwise 0 (undefined). SWC stores only
/// parents: a branch whose first or last point lies within 1.5 mm of an existing row is attached to that row; if
/// branches start at a point that no other branch reaches, the nearest free branch end within 10 mm is extended to that
/// point; other branches become roots. IDs and names are lost. Unknown radii are 0.
std::string swcText(const core::VesselTree& tree);

}   // namespace angiopose::io
