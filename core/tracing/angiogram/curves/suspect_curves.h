#pragma once

#include "core/vessel/centerline2d.h"

#include <vector>

namespace angiopose::core {

/// Whether a curve bends evenly (one arc, or straight) and keeps its width, whatever its length.
bool runsLikeDevice(const Curve2d& curve);

/// Ids of long curves that bend evenly (one arc, or straight) and keep their width, as catheters, wires and edges of
/// bones do and vessels seldom, and of closed loops of wire. They stay in the centreline: whether they count is for the
/// user to say. `imageSidePx` is the longer side of the frame; curves without radii are judged by their course alone.
std::vector<int> suspectCurves(const Centerline2d& centerline, int imageSidePx);

}   // namespace angiopose::core