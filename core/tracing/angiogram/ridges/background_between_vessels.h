#pragma once

#include "core/imaging/image2d.h"
#include "core/tracing/angiogram/ridges/vesselness.h"

#include <vector>

namespace angiopose::core {

/// Finds the bright background between two parallel vessels, which wide filters mistake for one vessel of twice the
/// width: bright lines in `vessels` that stand out at least as clearly as a vessel, are not weak relative to the
/// adjacent vessels, and are larger than texture. `evidence` is in units of `vesselThreshold`; `scales` are the filter
/// scales it was computed with, some of which respond to background.
Mask2d findBackgroundBetweenVessels(const Mask2d& vessels, const ImageF& evidence, const ImageF& opacity,
                                    const std::vector<RidgeScale>& scales, double vesselThreshold);

}   // namespace angiopose::core
