#pragma once

namespace angiopose::core {

/// One set of defaults for every image; lengths in px of a frame of usual size (see `WorkingSize`): in frames twice as
/// large they are twice as long.
struct TraceOptions {
    double minVesselRadiusPx = 1.5;   ///< thinnest vessel looked for
    double maxVesselRadiusPx = 0.0;   ///< widest vessel looked for; 0: see `widestVesselRadiusPx`
    int minBranchLengthPx = 10;   ///< shorter spurs are removed
    int minComponentLengthPx = 30;   ///< shorter isolated pieces are removed
    double sensitivity = 1.0;   ///< above 1: fainter vessels too; scales the threshold by 1/sensitivity

    bool operator==(const TraceOptions&) const = default;
};

}   // namespace angiopose::core
