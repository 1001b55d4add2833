#pragma once

namespace angiopose::core {

/// Tracing options, with defaults suitable for every image; lengths are in px of a frame of typical size (see
/// `WorkingSize`) and scale with the frame.
struct TraceOptions {
    double minVesselRadiusPx = 1.5;   ///< radius of the thinnest vessel
    double maxVesselRadiusPx = 0.0;   ///< radius of the widest vessel; if 0, determined by `widestVesselRadiusPx`
    int minBranchLengthPx = 10;   ///< shorter spurs are removed
    int minComponentLengthPx = 30;   ///< shorter isolated components are removed
    double sensitivity = 1.0;   ///< values above 1 include fainter vessels; divides the threshold

    bool operator==(const TraceOptions&) const = default;
};

}   // namespace angiopose::core
