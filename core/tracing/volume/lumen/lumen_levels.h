#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/tracing/volume/voxels/axis_order.h"

#include <limits>
#include <optional>

namespace angiopose::core {

/// Intensity levels of a scan, in its own units (HU for CT).
struct LumenLevels {
    double tissue = 0.0;   ///< level of the tissue around the vessels
    double blood = 1.0;   ///< level of the opacified lumen in wide vessels
    double threshold = 0.5;   ///< halfway value, at which the wall lies regardless of blurring
    bool isHu = false;   ///< whether values are Hounsfield units: the scan shows air, or fat and no denser body

    double contrast() const { return blood - tissue; }
};

/// Limits of the search for the lumen level.
struct LumenLevelSearch {
    std::optional<double> threshold = std::nullopt;   ///< lower limit of the lumen, if given
    double maxBlood = std::numeric_limits<double>::max();   ///< upper limit; bone is brighter
};

/// Returns whether the values appear to be Hounsfield units; see `LumenLevels`.
bool isInHounsfield(const Volume& volume, const AxisOrder& order);

/// Finds the histogram peaks of soft tissue and of the opacified lumen among voxels with homogeneous surroundings, i.e.
/// inside organs and wide vessels, not at walls or in bone. A given threshold is kept, and the tissue level follows
/// from it. Fails if no lumen peak stands out.
Result<LumenLevels> findLumenLevels(const Volume& volume, const AxisOrder& order, const LumenLevelSearch& search = {});

/// Finds the levels of a scan without Hounsfield units whose vessels are too thin to form peaks but brighter than
/// everything else: inflow (time-of-flight) MR angiography, or opacified arteries in rotational angiography. The lumen
/// level is the value of the brightest half milliliter, the tissue level the mode of the values between air and lumen.
/// Fails if the brightest voxels hardly stand out.
Result<LumenLevels> findBrightestLevels(const Volume& volume, const AxisOrder& order);

/// Returns the error for a scan in which no tree was found: the value taken for the lumen, and a remedy.
Error noVesselsError(const LumenLevels& level);

}   // namespace angiopose::core
