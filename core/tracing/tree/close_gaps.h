#pragma once

#include "core/tracing/tree/vessel_graph.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

namespace angiopose::core {

struct ClosedGaps {
    int count = 0;
    double longestMm = 0.0;   ///< between the walls
};

/// Joins pieces of a graph where it is clear that they are one vessel: two free ends that are each other's nearest, as
/// wide as one another, point at one another and have no more between their walls than twice the vessel's width (or two
/// voxels); four times where they are straight in line and no other end is near. Within a piece nothing is joined.
/// Incomplete when stopped.
ClosedGaps closeClearGaps(VesselGraph& graph, double voxelMm, TracingProgress& progress);

}   // namespace angiopose::core
