#pragma once

#include "core/imaging/image2d.h"
#include "core/tracing/angiogram/ridges/vesselness.h"

#include <vector>

namespace angiopose::core {

/// The bright ground between two vessels that run side by side, which wide filters take for one vessel twice as wide:
/// bright lines in `vessels` that stand out at least as clearly as a vessel would, are not weak against what is beside
/// them, and are longer than texture. `evidence` is of vessels, in units of `clearRidge`; `scales` are those it was
/// found with, of which some see ground.
Mask2d groundBetweenNeighbors(const Mask2d& vessels, const ImageF& evidence, const ImageF& opacity,
                              const std::vector<RidgeScale>& scales, double clearRidge);

}   // namespace angiopose::core