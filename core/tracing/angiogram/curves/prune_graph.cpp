#include "core/tracing/angiogram/curves/prune_graph.h"

#include <algorithm>
#include <numeric>

namespace angiopose::core {
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

/// Returns the index of the spur with the lowest score below `least`, or -1 if there is none.
int minSpur(const SkeletonGraph& graph, const std::vector<double>& worths, double least)
{
    const std::vector<int> degrees = degreesOf(graph);
    int found = -1;
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
        const int startDegree = degrees[static_cast<std::size_t>(graph.edges[i].startNode)];
        const int endDegree = degrees[static_cast<std::size_t>(graph.edges[i].endNode)];
        const bool isSpur = std::min(startDegree, endDegree) == 1 && std::max(startDegree, endDegree) > 2;
        if (isSpur && worths[i] < least) {
            found = static_cast<int>(i);
            least = worths[i];
        }
    }
    return found;
}

void reverse(SkeletonEdge& edge)
{
    std::reverse(edge.pointsPx.begin(), edge.pointsPx.end());
    std::swap(edge.startNode, edge.endNode);
}

/// Joins the edges at `node` if exactly two distinct edges meet there, and scores the joined edge.
void joinThrough(SkeletonGraph& graph, int node, std::vector<double>& worths, const EdgeMeasure& worth)
{
    std::vector<std::size_t> meeting;
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
        const SkeletonEdge& edge = graph.edges[i];
        if (edge.startNode == node || edge.endNode == node) {
            meeting.push_back(i);
        }
        if (edge.startNode == node && edge.endNode == node) {   // closed ring: both ends are at this node
            return;
        }
    }
    if (meeting.size() != 2) {
        return;
    }
    SkeletonEdge first = std::move(graph.edges[meeting[0]]);
    SkeletonEdge second = std::move(graph.edges[meeting[1]]);
    if (first.startNode == node) {
        reverse(first);
    }
    if (second.endNode == node) {
        reverse(second);
    }
    first.pointsPx.insert(first.pointsPx.end(), second.pointsPx.begin() + 1, second.pointsPx.end());
    first.endNode = second.endNode;
    worths[meeting[0]] = worth(first);
    graph.edges[meeting[0]] = std::move(first);
    graph.edges.erase(graph.edges.begin() + static_cast<std::ptrdiff_t>(meeting[1]));
    worths.erase(worths.begin() + static_cast<std::ptrdiff_t>(meeting[1]));
}

/// Returns a representative node of the connected component for each node.
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

SkeletonGraph withoutSpurs(SkeletonGraph graph, const EdgeMeasure& worth, double least)
{
    std::vector<double> worths;
    for (const SkeletonEdge& edge : graph.edges) {
        worths.push_back(worth(edge));
    }
    for (int spur = minSpur(graph, worths, least); spur >= 0; spur = minSpur(graph, worths, least)) {
        const int startNode = graph.edges[static_cast<std::size_t>(spur)].startNode;
        const int endNode = graph.edges[static_cast<std::size_t>(spur)].endNode;
        graph.edges.erase(graph.edges.begin() + spur);
        worths.erase(worths.begin() + spur);
        joinThrough(graph, startNode, worths, worth);
        joinThrough(graph, endNode, worths, worth);
    }
    return graph;
}

SkeletonGraph withoutSmallPieces(SkeletonGraph graph, const EdgeMeasure& size, double least)
{
    const std::vector<int> piece = piecesOf(graph);
    const auto pieceOf = [&](const SkeletonEdge& edge) {
        return static_cast<std::size_t>(piece[static_cast<std::size_t>(edge.startNode)]);
    };
    std::vector<double> sizes(graph.nodesPx.size(), 0.0);
    for (const SkeletonEdge& edge : graph.edges) {
        sizes[pieceOf(edge)] += size(edge);
    }
    std::erase_if(graph.edges, [&](const SkeletonEdge& edge) { return sizes[pieceOf(edge)] < least; });
    return graph;
}

}   // namespace angiopose::core
