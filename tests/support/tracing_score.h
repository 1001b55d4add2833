#pragma once

#include "core/simulation/simulated_case.h"
#include "core/tracing/angiogram/trace_angiogram.h"

namespace angiopose::test {

/// Agreement of a traced frame of a simulated run with the ground truth; lengths in px.
///
/// A vessel is visible if it is wider than 2 px, at least 5 px inside the exposed image, outside the lumen of other
/// vessels, and if its own contrast (noise-free, on its axis, above the higher of the two sides 2 px beyond its walls)
/// is at least twice the standard deviation of everything else around it (noise and misregistration, σ 8 px). A vessel
/// is found if a traced curve runs within 2 px of it. Traced length is false if it is farther than 2 px from the axis
/// of any opacified vessel or catheter, and outside their lumen.
struct TracingScore {
    double visiblePx = 0.0;
    double foundPx = 0.0;
    double tracedPx = 0.0;
    double falsePx = 0.0;
    double falseUnsuspectedPx = 0.0;   ///< part of the false length on curves not marked as suspect
    double suspectVesselPx = 0.0;   ///< correct length on curves marked as suspect (catheters not counted)
    double biasPx = 0.0;   ///< length of the mean offset vector of the found vessels
    double curveBiasPx = 0.0;   ///< mean over vessels of the absolute value of their mean lateral offset
    double radiusRatio = 0.0;   ///< found over true radius, median of the found vessels; 0 if none was found
    double catheterPx = 0.0;   ///< length traced along a catheter, away from vessels
    double flaggedCatheterPx = 0.0;   ///< part of the catheter length on curves marked as suspect

    double recall() const { return visiblePx > 0.0 ? foundPx / visiblePx : 1.0; }
    double falseShare() const { return tracedPx > 0.0 ? falsePx / tracedPx : 0.0; }
};

TracingScore scoreTracing(const core::SimulatedCase& simulated, const core::AngiogramTrace& trace);

}   // namespace angiopose::test
