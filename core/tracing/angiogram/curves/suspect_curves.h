#pragma once

#include "core/vessel/centerline2d.h"

#include <vector>

namespace angiopose::core {

/// Returns whether a curve of any length has uniform curvature (straight or a single arc) and constant width.
bool isDeviceLike(const Curve2d& curve);

/// Returns the ids of long curves with uniform curvature (straight or a single arc) and constant width, which are
/// typical of catheters, wires and bone edges but rare in vessels, and of closed wire loops. The curves stay in the
/// centerline; the user decides which ones to exclude. `imageSidePx` is the longer side of the frame; curves without
/// radii are judged by their shape alone.
std::vector<int> suspectCurves(const Centerline2d& centerline, int imageSidePx);

}   // namespace angiopose::core
