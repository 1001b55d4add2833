#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/tracing/volume/voxels/axis_order.h"

#include <limits>
#include <optional>

namespace angiopose::core {

/// Meaning of a scan's values, in its own units (HU for CT).
struct BloodLevel {
    double tissue = 0.0;   ///< value of the tissue around the vessels
    double blood = 1.0;   ///< value of the opacified lumen where it is wide
    double threshold = 0.5;   ///< halfway: position of the wall, unaffected by blurring
    bool isHu = false;   ///< Hounsfield units: the scan contains air, or fat and no denser body

    double contrast() const { return blood - tissue; }
};

/// Limits of the search for blood.
struct BloodSearch {
    std::optional<double> threshold = std::nullopt;   ///< lower limit of the lumen, if given
    double maxBlood = std::numeric_limits<double>::max();   ///< bone is brighter
};

/// Whether the values are Hounsfield units, judged by the values; see `BloodLevel`.
bool isInHounsfield(const Volume& volume, const AxisOrder& order);

/// Finds the peaks of soft tissue and of opacified blood in the histogram of the voxels with homogeneous surroundings,
/// i.e. inside organs and wide vessels, not at walls or in bone. A given threshold is kept, and the tissue value
/// follows from it. Fails if no blood stands out.
Result<BloodLevel> findBloodLevel(const Volume& volume, const AxisOrder& order, const BloodSearch& search = {});

/// Blood level of scans without Hounsfield units whose vessels are too thin to form peaks but brighter than everything
/// else: MR inflow, or opacified arteries in rotational angiography. Blood is the value of the brightest half
/// milliliter, tissue the mode of the values that are neither air nor blood. Fails if the brightest voxels hardly stand
/// out.
Result<BloodLevel> brightestLevel(const Volume& volume, const AxisOrder& order);

/// Error message for a scan with this level and no tree: which value was taken for blood, and what to do.
Error noVesselsFound(const BloodLevel& level);

}   // namespace angiopose::core