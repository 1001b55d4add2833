#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// A stretch of skeleton between two nodes; its points begin and end at them.
struct SkeletonEdge {
    int startNode = 0;
    int endNode = 0;
    std::vector<Eigen::Vector2d> pointsPx;
};

/// Junctions and free ends of a skeleton, and what runs between them. A closed ring is an edge from a node to itself.
struct SkeletonGraph {
    std::vector<Eigen::Vector2d> nodesPx;
    std::vector<SkeletonEdge> edges;
};

/// Graph of a one pixel wide skeleton; touching junction pixels are one node at their centroid.
SkeletonGraph skeletonGraph(const Mask2d& skeleton);

/// Ordered curves through the graph: at each node, edges that continue each other straight on are joined, so that two
/// crossing vessels give two curves. A crossing that thinning split in two junctions up to `crossingPx` apart is one.
std::vector<std::vector<Eigen::Vector2d>> orderedCurves(const SkeletonGraph& graph, double crossingPx);

}   // namespace angiopose::core