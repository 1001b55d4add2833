#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/axis_order.h"

#include <optional>

namespace angiopose::core {

/// A scan corrected for the intensity inhomogeneity due to coil sensitivity (bias-field correction).
struct BiasCorrectedScan {
    Volume volume;   ///< corrected scan, scaled to the highest coil sensitivity
    double sensitivityRatio = 1.0;   ///< largest ratio of coil sensitivities within the body
};

/// Corrects MR scans whose tissue darkens from one place to another by more than half, smoothly enough for the coil to
/// be the cause; nullopt for CT, where only air, fat and soft tissue differ. Uses as much memory as the scan.
std::optional<BiasCorrectedScan> correctBiasField(const Volume& volume, const AxisOrder& order);

}   // namespace angiopose::core
