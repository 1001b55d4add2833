#pragma once

#include "core/tracing/tree/vessel_graph.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <vector>

namespace angiopose::core {

/// Cuts every loop at its weakest point: vessels form trees, and a loop usually consists of two touching vessels. Keeps
/// a spanning tree of maximum relative width (minimum width of an edge over the width at its nodes); all other edges
/// are cut at their thinnest point, and both halves are kept. Returns the number of loops.
int openLoops(VesselGraph& graph);

struct LoopCount {
    int opened = 0;
    int kept = 0;
};

/// Like `openLoops`, but keeps loops whose circumference exceeds what `minLengthMm` and the thickness of their vessels
/// account for; smaller loops are segmentation flaws. Incomplete when stopped.
LoopCount openSmallLoops(VesselGraph& graph, double minLengthMm, TracingProgress& progress);

/// Removes the edges that close loops and returns them; the remaining graph is the spanning forest of `openLoops`.
std::vector<VesselEdge> extractClosingEdges(VesselGraph& graph);

}   // namespace angiopose::core
