#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

namespace angiopose::core {

/// Returns the mask of the pixels whose centers lie between the walls of a curve, i.e. closer to the curve than its
/// radius at that point. Curves without radii are ignored.
Mask2d rasterizeVessels(const Centerline2d& centerline, int width, int height);

}   // namespace angiopose::core
