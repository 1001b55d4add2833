#pragma once

#include "core/imaging/image2d.h"

#include <vector>

namespace angiopose::core {

/// Return the mask eroded or dilated by a square of side 2·`radiusPx` + 1; edge pixels are replicated outward.
Mask2d erode(const Mask2d& mask, int radiusPx);
Mask2d dilate(const Mask2d& mask, int radiusPx);

/// Returns the 8-connected components of the mask that touch the image edge.
Mask2d edgeComponents(const Mask2d& mask);

/// Returns the mask with its small holes filled: 4-connected background regions of at most `maxAreaPx` that do not
/// reach the image edge. Intended for small areas.
Mask2d fillSmallHoles(Mask2d mask, int maxAreaPx);

/// Returns the 8-connected components as lists of pixel indices, in order of their first pixel.
std::vector<std::vector<std::size_t>> componentsOf(const Mask2d& mask);

}   // namespace angiopose::core
