#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/tracing/volume/voxels/axis_order.h"

#include <limits>
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

/// Where blood is looked for.
struct BloodSearch {
    std::optional<double> threshold = std::nullopt;   ///< where the lumen begins, if that was said
    double maxBlood = std::numeric_limits<double>::max();   ///< bone is brighter
};

/// By its values; see `BloodLevel`.
bool isInHounsfield(const Volume& volume, const AxisOrder& order);

/// Finds the peaks of soft tissue and of contrast-filled blood in the histogram of the voxels around which nothing
/// changes: inside organs and wide vessels, not at walls nor in bone. A given threshold is kept, and the tissue follows
/// from it. Fails when no blood stands out.
Result<BloodLevel> findBloodLevel(const Volume& volume, const AxisOrder& order, const BloodSearch& search = {});

/// The same for scans without Hounsfield units whose vessels are too thin for peaks, and brighter than all else: the
/// inflow of MR, the filled arteries of rotational angiography. Blood is as the brightest half millilitre, tissue as
/// most of what is neither air nor that. Fails where the brightest hardly stands out.
Result<BloodLevel> brightestLevel(const Volume& volume, const AxisOrder& order);

/// Why a scan with this level has no tree, in the words for users: what was taken for blood, and what to do.
Error noVesselsFound(const BloodLevel& level);

}   // namespace angiopose::core