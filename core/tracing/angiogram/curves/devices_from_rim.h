#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

#include <vector>

namespace angiopose::core {

/// Ids of curves that start at the rim of the field and look like catheters or guidewires (a single arc of constant
/// width) over at least half of their length; tracing joins a catheter with the vessel that its tip lies in. Ascending
/// if the curve ids are.
std::vector<int> devicesFromRim(const Centerline2d& centerline, const Mask2d& field);

}   // namespace angiopose::core
