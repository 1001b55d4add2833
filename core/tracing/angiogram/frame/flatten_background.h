#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Computes how much darker each pixel is than its surroundings (vessels positive): subtracts the slow background and
/// the edge of the field, and raises contrast in dark regions to that in bright ones. In gray values at the median
/// background; 0 outside `field`. `reachPx` is the width of the surroundings, well above a vessel's width.
ImageF flattenBackground(const ImageF& vesselsDark, const Mask2d& field, double reachPx);

}   // namespace angiopose::core
