#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// How much darker each pixel is than its surroundings (vessels positive): the slow background and the edge of the
/// field taken away, contrast in dark parts raised towards that in bright ones. In grey values at the middle
/// background; 0 outside `field`. `reachPx` is the width of the surroundings, well above a vessel's.
ImageF flattenBackground(const ImageF& vesselsDark, const Mask2d& field, double reachPx);

}   // namespace angiopose::core