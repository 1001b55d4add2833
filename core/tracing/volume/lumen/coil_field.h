#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/axis_order.h"

#include <optional>

namespace angiopose::core {

/// A scan as a coil would give it that receives alike everywhere.
struct BiasCorrectedScan {
    Volume volume;   ///< the values of where the coil receives best
    double fallOff = 1.0;   ///< how many times weaker the coil received elsewhere in the body
};

/// MR scans whose tissue gets darker from one place to another by more than half, evenly enough to be the coil's doing:
/// none for CT, where air, fat and organs alone differ. Takes as much memory as the scan.
std::optional<BiasCorrectedScan> biasCorrected(const Volume& volume, const AxisOrder& order);

}   // namespace angiopose::core
