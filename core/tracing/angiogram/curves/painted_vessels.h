#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

namespace angiopose::core {

/// The pixels whose centres lie between the walls of a curve: nearer to it than its radius there. Curves without radii
/// paint nothing.
Mask2d paintedVessels(const Centerline2d& centerline, int width, int height);

}   // namespace angiopose::core
