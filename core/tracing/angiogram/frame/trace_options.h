#pragma once

namespace angiopose::core {

/// Defaults for every image; lengths are in px of a frame of typical size (see `WorkingSize`) and scale with the frame.
struct TraceOptions {
    double minVesselRadiusPx = 1.5;   ///< thinnest vessel searched for
    double maxVesselRadiusPx = 0.0;   ///< widest vessel searched for; 0: see `widestVesselRadiusPx`
    int minBranchLengthPx = 10;   ///< shorter spurs are removed
    int minComponentLengthPx = 30;   ///< shorter isolated pieces are removed
    double sensitivity = 1.0;   ///< above 1: also fainter vessels; scales the threshold by 1/sensitivity

    bool operator==(const TraceOptions&) const = default;
};

}   // namespace angiopose::core
