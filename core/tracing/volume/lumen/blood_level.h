#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/tracing/volume/voxels/axis_order.h"

#include <optional>

namespace angiopose::core {

/// What the values of a scan mean, in its own values (HU for CT).
struct BloodLevel {
    double tissue = 0.0;   ///< of what surrounds the vessels
    double blood = 1.0;   ///< of contrast-filled lumen where it is wide
    double threshold = 0.5;   ///< half way: there lies the wall, unmoved by blurring
    bool isHu = false;   ///< Hounsfield units: there is air in the scan, or fat and no body of greater values

    double contrast() const { return blood - tissue; }
};

/// Finds the peaks of soft tissue and of contrast-filled blood in the histogram of the voxels around which nothing
/// changes: inside organs and wide vessels, not at walls nor in bone. A given threshold is kept, and the tissue follows
/// from it. Fails when no blood stands out.
Result<BloodLevel> findBloodLevel(const Volume& volume, const AxisOrder& order, std::optional<double> threshold);

/// Why a scan with this level has no tree, in the words for users: what was taken for blood, and what to do.
Error noVesselsFound(const BloodLevel& level);

}   // namespace angiopose::core