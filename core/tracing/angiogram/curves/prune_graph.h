#pragma once

#include "core/tracing/angiogram/curves/skeleton_graph.h"

#include <functional>

namespace angiopose::core {

/// Size or worth of an edge, such as its length or the evidence along it.
using EdgeMeasure = std::function<double(const SkeletonEdge&)>;

/// Removes spurs: while a branch between a junction and a free end is worth less than `least`, removes the one of
/// lowest worth. Edges that then continue each other become one.
SkeletonGraph withoutSpurs(SkeletonGraph graph, const EdgeMeasure& worth, double least);

/// Removes connected components whose edges sum up to less than `least`.
SkeletonGraph withoutSmallPieces(SkeletonGraph graph, const EdgeMeasure& size, double least);

}   // namespace angiopose::core