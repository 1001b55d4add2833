#pragma once

#include "core/simulation/simulated_case.h"
#include "core/tracing/angiogram/trace_angiogram.h"

namespace angiopose::test {

/// How a traced frame of a simulated run agrees with what is known of it; lengths in px.
///
/// A vessel is visible where it is wider than 2 px, at least 5 px inside the exposed image, outside the lumen of other
/// vessels, and where its own contrast (noise-free, on its axis, above the higher of the two sides 2 px beyond its
/// walls) is at least twice the standard deviation of everything else around (noise and misregistration, σ 8 px).
/// It is found where a traced curve runs within 2 px. Traced length is false where it is farther than 2 px from the
/// axis of any filled vessel or catheter, and outside their lumen.
struct TracingScore {
    double visiblePx = 0.0;
    double foundPx = 0.0;
    double tracedPx = 0.0;
    double falsePx = 0.0;
    double falseUnsuspectedPx = 0.0;   ///< of that, on curves not marked as suspect
    double suspectVesselPx = 0.0;   ///< not false, but on curves marked as suspect (catheters not counted)
    double biasPx = 0.0;   ///< mean offset of found vessels, length of the vector
    double curveBiasPx = 0.0;   ///< mean over vessels of their mean offset sideways, without sign
    double radiusRatio = 0.0;   ///< found over true, median of the found vessels; 0 where none was found
    double catheterPx = 0.0;   ///< traced along a catheter, away from vessels
    double flaggedCatheterPx = 0.0;   ///< of that, on curves marked as suspect

    double recall() const { return visiblePx > 0.0 ? foundPx / visiblePx : 1.0; }
    double falseShare() const { return tracedPx > 0.0 ? falsePx / tracedPx : 0.0; }
};

TracingScore scoreTracing(const core::SimulatedCase& simulated, const core::AngiogramTrace& trace);

}   // namespace angiopose::test