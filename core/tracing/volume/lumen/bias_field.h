#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/axis_order.h"

#include <optional>

namespace angiopose::core {

/// A scan with the coil's inhomogeneity removed (bias-field correction).
struct BiasCorrectedScan {
    Volume volume;   ///< corrected scan, scaled to the highest coil sensitivity
    double sensitivityRatio = 1.0;   ///< largest ratio of coil sensitivities within the body
};

/// Corrects MR scans whose tissue darkens from one place to another by more than half, smoothly enough to be caused by
/// the coil; nothing for CT, where only air, fat and organs differ. Uses as much memory as the scan.
std::optional<BiasCorrectedScan> correctBiasField(const Volume& volume, const AxisOrder& order);

}   // namespace angiopose::core
