#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

#include <vector>

namespace angiopose::core {

/// Returns the ids of curves that start at the edge of the field and look like catheters or guidewires (a single arc of
/// constant width) over at least half of their length; the rest of such a curve may be the vessel in which the catheter
/// tip lies. The ids are ascending if those of the curves are.
std::vector<int> findDevicesFromEdge(const Centerline2d& centerline, const Mask2d& field);

}   // namespace angiopose::core
