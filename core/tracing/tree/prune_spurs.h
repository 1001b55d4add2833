#pragma once

#include "core/tracing/tree/vessel_graph.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

namespace angiopose::core {

struct SpurLimits {
    double minLengthMm = 6.0;   ///< beyond the wall of the vessel it leaves
    double minRadiusMm = 0.0;   ///< average along the spur
    double minLengthInRadii = 1.5;   ///< in its own radii: a shorter spur is a bulge of the wall
};

/// Removes spurs, the least important first, until none is below the limits; edges that then continue each other are
/// joined. A vessel without branches is not a spur; it is removed only if its whole length is below `minLengthMm`.
/// Incomplete when stopped.
void pruneSpurs(VesselGraph& graph, const SpurLimits& limits, TracingProgress& progress);

}   // namespace angiopose::core