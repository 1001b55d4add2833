#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

#include <vector>

namespace angiopose::core {

/// Ids of curves that come from the field's rim and run as catheters and wires do (one arc, of one width) for at least
/// half of their length: tracing joins a catheter with the vessel that its tip lies in. Ascending where ids are.
std::vector<int> devicesFromRim(const Centerline2d& centerline, const Mask2d& field);

}   // namespace angiopose::core
