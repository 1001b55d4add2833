#pragma once

#include "core/vessel/centerline2d.h"

#include <vector>

namespace angiopose::core {

/// Whether a curve has uniform curvature (a single arc, or straight) and constant width, whatever its length.
bool runsLikeDevice(const Curve2d& curve);

/// Ids of long curves with uniform curvature (a single arc, or straight) and constant width, as catheters, wires and
/// bone edges have and vessels rarely do, and of closed wire loops. They stay in the centerline: the user decides
/// whether they count. `imageSidePx` is the longer side of the frame; curves without radii are judged by their course
/// alone.
std::vector<int> suspectCurves(const Centerline2d& centerline, int imageSidePx);

}   // namespace angiopose::core