#pragma once

#include "core/tracing/tree/vessel_graph.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <vector>

namespace angiopose::core {

/// Opens every loop at its weakest place: vessels form trees, and a loop is mostly two vessels that touch. The edges
/// that stay whole are a spanning tree of greatest relative width (width at the narrowest point over that of the nodes
/// it joins); the others are cut where they are thinnest and keep both halves. Returns how many loops there were.
int openLoops(VesselGraph& graph);

struct LoopCount {
    int opened = 0;
    int kept = 0;
};

/// The same, but loops whose way around is longer than `minLengthMm` and than the vessels on it are thick stay as
/// they are. Shorter ones are flaws of the lumen. Incomplete when stopped.
LoopCount openSmallLoops(VesselGraph& graph, double minLengthMm, TracingProgress& progress);

/// Takes out the edges that close loops, so that the rest is a spanning forest, as `openLoops` would leave it.
std::vector<VesselEdge> takeClosingEdges(VesselGraph& graph);

}   // namespace angiopose::core
