#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Section of a skeleton between two nodes; its points begin and end at the nodes.
struct SkeletonEdge {
    int startNode = 0;
    int endNode = 0;
    std::vector<Eigen::Vector2d> pointsPx;
};

/// Junctions and free ends of a skeleton, and the edges between them. A closed ring is an edge from a node to itself.
struct SkeletonGraph {
    std::vector<Eigen::Vector2d> nodesPx;
    std::vector<SkeletonEdge> edges;
};

/// Builds the graph of a one-pixel-wide skeleton; adjacent junction pixels form one node at their centroid.
SkeletonGraph buildSkeletonGraph(const Mask2d& skeleton);

/// Orders the graph into curves: at each node, joins edges that continue each other straight, so two crossing vessels
/// give two curves. Two junctions up to `crossingPx` apart that thinning created at one crossing count as one.
std::vector<std::vector<Eigen::Vector2d>> orderCurves(const SkeletonGraph& graph, double crossingPx);

}   // namespace angiopose::core
