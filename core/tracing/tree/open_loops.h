#pragma once

#include "core/tracing/tree/vessel_graph.h"

namespace angiopose::core {

/// Opens every loop at its weakest place: vessels form trees, and a loop is mostly two vessels that touch. The edges
/// that stay whole are a spanning tree of greatest relative width (width at the narrowest point over that of the nodes
/// it joins); the others are cut where they are thinnest and keep both halves. Returns how many loops there were.
int openLoops(VesselGraph& graph);

}   // namespace angiopose::core