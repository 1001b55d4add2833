#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Computes how much darker each pixel is than its surroundings (vessels positive): subtracts the slowly varying
/// background and the edge of the field, and raises the contrast of dark regions to that of bright ones. The result is
/// in gray values at the median background; 0 outside `field`. `reachPx`, the width of the surroundings, must be well
/// above a vessel's width.
ImageF flattenBackground(const ImageF& vesselsDark, const Mask2d& field, double reachPx);

}   // namespace angiopose::core
