#pragma once

#include "core/tracing/angiogram/curves/skeleton_graph.h"

#include <functional>

namespace angiopose::core {

/// Some size or worth of an edge: its length, the evidence along it, …
using EdgeMeasure = std::function<double(const SkeletonEdge&)>;

/// Without spurs: as long as a branch with a free end at a junction is worth less than `least`, the one of least worth
/// goes. Edges that then continue each other become one.
SkeletonGraph withoutSpurs(SkeletonGraph graph, const EdgeMeasure& worth, double least);

/// Without the pieces (connected parts) whose edges sum up to less than `least`.
SkeletonGraph withoutSmallPieces(SkeletonGraph graph, const EdgeMeasure& size, double least);

}   // namespace angiopose::core