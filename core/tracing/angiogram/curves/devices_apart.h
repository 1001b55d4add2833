#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

#include <vector>

namespace angiopose::core {

/// The curves with parts cut off that come from the field's rim and run there as catheters and wires do (one arc, of
/// one width) before they go on otherwise: tracing joins a catheter with the vessel that its tip lies in. The parts are
/// found by `suspectCurves` then. Ids are given anew, from 1.
std::vector<Curve2d> withDevicesApart(std::vector<Curve2d> curves, const Mask2d& field);

}   // namespace angiopose::core
