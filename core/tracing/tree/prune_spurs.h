#pragma once

#include "core/tracing/tree/vessel_graph.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

namespace angiopose::core {

struct SpurLimits {
    double minLengthMm = 6.0;   ///< length beyond the wall of the parent vessel
    double minRadiusMm = 0.0;   ///< mean radius along the spur
    double minLengthInRadii = 1.5;   ///< in spur radii; shorter spurs are bulges of the wall
};

/// Removes spurs below the limits, lowest score first, and joins edges that then continue each other. A vessel without
/// branches is not a spur; it is removed only if its whole length is below `minLengthMm`. Incomplete when stopped.
void pruneSpurs(VesselGraph& graph, const SpurLimits& limits, TracingProgress& progress);

}   // namespace angiopose::core
