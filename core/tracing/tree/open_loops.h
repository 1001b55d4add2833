#pragma once

#include "core/tracing/tree/vessel_graph.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <vector>

namespace angiopose::core {

/// Opens every loop at its weakest place: vessels form trees, and a loop usually consists of two vessels that touch.
/// The edges that stay whole are a spanning tree of maximum relative width (width at the narrowest point over that of
/// the nodes it joins); the others are cut where they are thinnest and keep both halves. Returns the number of loops.
int openLoops(VesselGraph& graph);

struct LoopCount {
    int opened = 0;
    int kept = 0;
};

/// Same as `openLoops`, but keeps loops whose circumference is longer than `minLengthMm` and than the thickness of
/// their vessels; shorter ones are flaws of the lumen. Incomplete when stopped.
LoopCount openSmallLoops(VesselGraph& graph, double minLengthMm, TracingProgress& progress);

/// Removes the edges that close loops and returns them; the rest is a spanning forest, as `openLoops` would leave it.
std::vector<VesselEdge> takeClosingEdges(VesselGraph& graph);

}   // namespace angiopose::core
