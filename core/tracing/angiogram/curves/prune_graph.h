#pragma once

#include "core/tracing/angiogram/curves/skeleton_graph.h"

#include <functional>

namespace angiopose::core {

/// Size or score of an edge, such as its length or the vessel evidence along the edge.
using EdgeMeasure = std::function<double(const SkeletonEdge&)>;

/// Removes spurs (edges between a junction and a free end), weakest first, until none scores below `threshold`; joins
/// edges that then continue each other.
SkeletonGraph removeSpurs(SkeletonGraph graph, const EdgeMeasure& score, double threshold);

/// Removes connected components whose total edge size is below `threshold`.
SkeletonGraph removeSmallComponents(SkeletonGraph graph, const EdgeMeasure& size, double threshold);

}   // namespace angiopose::core
