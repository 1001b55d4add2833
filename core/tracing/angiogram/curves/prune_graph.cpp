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

/// Returns the index of the spur with the lowest score below the threshold, or -1 if there is none.
int findWeakestSpur(const SkeletonGraph& graph, const std::vector<double>& scores, double threshold)
{
    const std::vector<int> degrees = degreesOf(graph);
    int weakest = -1;
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
        const int startDegree = degrees[static_cast<std::size_t>(graph.edges[i].startNode)];
        const int endDegree = degrees[static_cast<std::size_t>(graph.edges[i].endNode)];
        const bool isSpur = std::min(startDegree, endDegree) == 1 && std::max(startDegree, endDegree) > 2;
        if (isSpur && scores[i] < threshold) {
            weakest = static_cast<int>(i);
            threshold = scores[i];
        }
    }
    return weakest;
}

void reverse(SkeletonEdge& edge)
{
    std::reverse(edge.pointsPx.begin(), edge.pointsPx.end());
    std::swap(edge.startNode, edge.endNode);
}

/// Joins the edges at `node` if exactly two distinct edges meet there, and scores the joined edge.
void mergeEdgesAt(SkeletonGraph& graph, int node, std::vector<double>& scores, const EdgeMeasure& score)
{
    std::vector<std::size_t> edgesAtNode;
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
        const SkeletonEdge& edge = graph.edges[i];
        if (edge.startNode == node || edge.endNode == node) {
            edgesAtNode.push_back(i);
        }
        if (edge.startNode == node && edge.endNode == node) {   // closed ring: both ends are at this node
            return;
        }
    }
    if (edgesAtNode.size() != 2) {
        return;
    }
    SkeletonEdge first = std::move(graph.edges[edgesAtNode[0]]);
    SkeletonEdge second = std::move(graph.edges[edgesAtNode[1]]);
    if (first.startNode == node) {
        reverse(first);
    }
    if (second.endNode == node) {
        reverse(second);
    }
    first.pointsPx.insert(first.pointsPx.end(), second.pointsPx.begin() + 1, second.pointsPx.end());
    first.endNode = second.endNode;
    scores[edgesAtNode[0]] = score(first);
    graph.edges[edgesAtNode[0]] = std::move(first);
    graph.edges.erase(graph.edges.begin() + static_cast<std::ptrdiff_t>(edgesAtNode[1]));
    scores.erase(scores.begin() + static_cast<std::ptrdiff_t>(edgesAtNode[1]));
}

/// Returns, for each node, a representative node of its connected component.
std::vector<int> componentOfNodes(const SkeletonGraph& graph)
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

SkeletonGraph removeSpurs(SkeletonGraph graph, const EdgeMeasure& score, double threshold)
{
    std::vector<double> scores;
    for (const SkeletonEdge& edge : graph.edges) {
        scores.push_back(score(edge));
    }
    for (int spur = findWeakestSpur(graph, scores, threshold); spur >= 0;
         spur = findWeakestSpur(graph, scores, threshold)) {
        const int startNode = graph.edges[static_cast<std::size_t>(spur)].startNode;
        const int endNode = graph.edges[static_cast<std::size_t>(spur)].endNode;
        graph.edges.erase(graph.edges.begin() + spur);
        scores.erase(scores.begin() + spur);
        mergeEdgesAt(graph, startNode, scores, score);
        mergeEdgesAt(graph, endNode, scores, score);
    }
    return graph;
}

SkeletonGraph removeSmallComponents(SkeletonGraph graph, const EdgeMeasure& size, double threshold)
{
    const std::vector<int> component = componentOfNodes(graph);
    const auto componentOf = [&](const SkeletonEdge& edge) {
        return static_cast<std::size_t>(component[static_cast<std::size_t>(edge.startNode)]);
    };
    std::vector<double> sizes(graph.nodesPx.size(), 0.0);
    for (const SkeletonEdge& edge : graph.edges) {
        sizes[componentOf(edge)] += size(edge);
    }
    std::erase_if(graph.edges, [&](const SkeletonEdge& edge) { return sizes[componentOf(edge)] < threshold; });
    return graph;
}

}   // namespace angiopose::core
