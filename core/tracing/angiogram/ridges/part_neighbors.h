#pragma once

#include "core/imaging/image2d.h"
#include "core/tracing/angiogram/ridges/vesselness.h"

#include <vector>

namespace angiopose::core {

/// Bright background between two parallel vessels, which wide filters mistake for one vessel twice as wide: bright
/// lines in `vessels` that stand out at least as clearly as a vessel would, are not weak compared with their
/// surroundings, and are longer than texture. `evidence` is the vessel evidence in units of `clearRidge`; `scales` are
/// the scales it was computed with, some of which respond to background.
Mask2d groundBetweenNeighbors(const Mask2d& vessels, const ImageF& evidence, const ImageF& opacity,
                              const std::vector<RidgeScale>& scales, double clearRidge);

}   // namespace angiopose::core