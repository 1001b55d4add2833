#pragma once

#include "core/tracing/tree/vessel_graph.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

namespace angiopose::core {

struct ClosedGaps {
    int count = 0;
    double maxGapMm = 0.0;   ///< longest closed gap, wall to wall
};

/// Joins components of a graph that are clearly one vessel: two free ends that are each other's nearest, have similar
/// widths, point at each other and have at most twice the vessel's width (or two voxels) between their walls; four
/// times if they are collinear and no other end is near. Nothing is joined within a component. Incomplete when stopped.
ClosedGaps closeClearGaps(VesselGraph& graph, double voxelMm, TracingProgress& progress);

}   // namespace angiopose::core
