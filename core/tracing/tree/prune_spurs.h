#pragma once

#include "core/tracing/tree/vessel_graph.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

namespace angiopose::core {

struct SpurLimits {
    double minLengthMm = 6.0;   ///< beyond the wall of the vessel it leaves
    double minRadiusMm = 0.0;   ///< on average
    double minLengthInRadii = 1.5;   ///< of its own: a shorter one is a bulge of the wall
};

/// Removes spurs, the least first, until none is below the limits; edges that then continue each other are joined.
/// A vessel without branches is no spur; it goes only when it is shorter than `minLengthMm` as a whole. Incomplete when
/// stopped.
void pruneSpurs(VesselGraph& graph, const SpurLimits& limits, TracingProgress& progress);

}   // namespace angiopose::core