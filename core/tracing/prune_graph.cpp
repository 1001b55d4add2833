#include "core/tracing/skeleton_graph.h"
#include "core/vessel/polyline.h"

#include <algorithm>
#include <numeric>

namespace core {
namespace {

std::vector<int> degreesOf(const SkeletonGraph& graph)
{
    std::vector<int> degrees(graph.nodesPx.size(), 0);
    for (const SkeletonEdge& edge : graph.edges) {
        ++degrees[static_cast<std::size_t>(edge.startNode)];
        ++degrees[static_cast<std::size_t>(edge.endNode)];
    }
    return degrees;
}

/// Index of the shortest edge with one free end at a junction, if below the limit; -1 if none.
int shortestSpur(const SkeletonGraph& graph, double minLengthPx)
{
    const std::vector<int> degrees = degreesOf(graph);
    int shortest = -1;
    double shortestLength = minLengthPx;
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
        const int startDegree = degrees[static_cast<std::size_t>(graph.edges[i].startNode)];
        const int endDegree = degrees[static_cast<std::size_t>(graph.edges[i].endNode)];
        const bool isSpur = std::min(startDegree, endDegree) == 1 && std::max(startDegree, endDegree) > 2;
        const double length = polylineLength(graph.edges[i].pointsPx);
        if (isSpur && length < shortestLength) {
            shortest = static_cast<int>(i);
            shortestLength = length;
        }
    }
    return shortest;
}

/// Joins the two edges that meet at `node`, if exactly two distinct ones do.
void joinThrough(SkeletonGraph& graph, int node)
{
    std::vector<std::size_t> meeting;
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
        if (graph.edges[i].startNode == node || graph.edges[i].endNode == node) {
            meeting.push_back(i);
        }
    }
    if (meeting.size() != 2) {
        return;
    }
    SkeletonEdge first = graph.edges[meeting[0]];
    SkeletonEdge second = graph.edges[meeting[1]];
    if (first.startNode == first.endNode || second.startNode == second.endNode) {
        return;
    }
    if (first.startNode == node) {
        std::reverse(first.pointsPx.begin(), first.pointsPx.end());
        std::swap(first.startNode, first.endNode);
    }
    if (second.endNode == node) {
        std::reverse(second.pointsPx.begin(), second.pointsPx.end());
        std::swap(second.startNode, second.endNode);
    }
    first.pointsPx.insert(first.pointsPx.end(), second.pointsPx.begin() + 1, second.pointsPx.end());
    first.endNode = second.endNode;
    graph.edges[meeting[0]] = std::move(first);
    graph.edges.erase(graph.edges.begin() + static_cast<std::ptrdiff_t>(meeting[1]));
}

/// For each node the representative of its connected piece.
std::vector<int> piecesOf(const SkeletonGraph& graph)
{
    std::vector<int> parent(graph.nodesPx.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto find = [&](int node) {
        while (parent[static_cast<std::size_t>(node)] != node) {
            node = parent[static_cast<std::size_t>(node)];
        }
        return node;
    };
    for (const SkeletonEdge& edge : graph.edges) {
        parent[static_cast<std::size_t>(find(edge.startNode))] = find(edge.endNode);
    }
    for (int node = 0; node < static_cast<int>(parent.size()); ++node) {
        parent[static_cast<std::size_t>(node)] = find(node);
    }
    return parent;
}

}   // namespace

SkeletonGraph pruned(const SkeletonGraph& graph, double minLengthPx, double minPieceLengthPx)
{
    SkeletonGraph kept = graph;
    for (int spur = shortestSpur(kept, minLengthPx); spur >= 0; spur = shortestSpur(kept, minLengthPx)) {
        const SkeletonEdge edge = kept.edges[static_cast<std::size_t>(spur)];
        kept.edges.erase(kept.edges.begin() + spur);
        joinThrough(kept, edge.startNode);
        joinThrough(kept, edge.endNode);
    }
    const std::vector<int> piece = piecesOf(kept);
    std::vector<double> pieceLength(kept.nodesPx.size(), 0.0);
    for (const SkeletonEdge& edge : kept.edges) {
        pieceLength[static_cast<std::size_t>(piece[static_cast<std::size_t>(edge.startNode)])] +=
            polylineLength(edge.pointsPx);
    }
    std::erase_if(kept.edges, [&](const SkeletonEdge& edge) {
        return pieceLength[static_cast<std::size_t>(piece[static_cast<std::size_t>(edge.startNode)])] <
               minPieceLengthPx;
    });
    return kept;
}

}   // namespace core
