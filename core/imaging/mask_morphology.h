#pragma once

#include "core/imaging/image2d.h"

#include <vector>

namespace angiopose::core {

/// Erosion and dilation by a square of side 2·`radiusPx` + 1; beyond the image the mask goes on as its edge pixels.
Mask2d eroded(const Mask2d& mask, int radiusPx);
Mask2d dilated(const Mask2d& mask, int radiusPx);

/// The parts (8-connected) of the mask that touch the image edge.
Mask2d connectedToEdge(const Mask2d& mask);

/// The mask with holes (4-connected background not reaching the image edge) of at most `maxAreaPx` filled;
/// meant for small areas.
Mask2d withHolesFilled(Mask2d mask, int maxAreaPx);

/// 8-connected components as lists of pixel indices, in order of their first pixel.
std::vector<std::vector<std::size_t>> componentsOf(const Mask2d& mask);

}   // namespace angiopose::core