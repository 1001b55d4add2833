#pragma once

#include "core/imaging/image2d.h"

namespace core {

/// How much darker each pixel is than its surroundings (vessels positive), with the slow background and the edge of
/// the field taken away. 0 outside `field`. `reachPx` is the width of the surroundings, well above a vessel's.
ImageF flattenBackground(const ImageF& vesselsDark, const Mask2d& field, double reachPx);

}   // namespace core
