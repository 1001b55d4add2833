#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/axis_order.h"

#include <optional>

namespace angiopose::core {

/// A scan with the coil's inhomogeneity removed (bias-field correction).
struct BiasCorrectedScan {
    Volume volume;   ///< scaled to where the coil's sensitivity is highest
    double fallOff = 1.0;   ///< factor by which the coil received weaker elsewhere in the body
};

/// Corrects MR scans whose tissue darkens from one place to another by more than half, smoothly enough to be caused by
/// the coil; nothing for CT, where only air, fat and organs differ. Uses as much memory as the scan.
std::optional<BiasCorrectedScan> biasCorrected(const Volume& volume, const AxisOrder& order);

}   // namespace angiopose::core
