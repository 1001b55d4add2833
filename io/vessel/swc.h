#pragma once

#include "io/vessel/line_set.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// SWC rows `id type x y z radius parent` as segments between points.
core::Result<LineSet> parseSwc(std::string_view text, const std::string& path);

/// A tree as SWC rows, in mm, type 5 where branches meet, else 0 (undefined). SWC knows parents only: a branch whose
/// first or last point lies within 1.5 mm of what is written before it hangs there; branches that begin together where
/// no other reaches hang at the nearest free end of one that ends within 10 mm, which is led on to them; others are
/// roots. Ids and names are lost. Unknown radii are 0.
std::string swcText(const core::VesselTree& tree);

}   // namespace angiopose::io