#include "core/tracing/tree/open_loops.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace angiopose::core {
namespace {

/// Returns the index of the thinnest inner point of the edge; among equally thin points, the one nearest to the middle.
std::size_t thinnestPoint(const VesselEdge& edge)
{
    const std::size_t middle = edge.radiusMm.size() / 2;
    const auto fromMiddle = [&](std::size_t i) { return i > middle ? i - middle : middle - i; };
    std::size_t best = middle;
    for (std::size_t i = 1; i + 1 < edge.radiusMm.size(); ++i) {
        const double difference = edge.radiusMm[i] - edge.radiusMm[best];
        if (difference < -1e-9 || (difference < 1e-9 && fromMiddle(i) < fromMiddle(best))) {
            best = i;
        }
    }
    return best;
}

double relativeWidth(const VesselGraph& graph, const VesselEdge& edge)
{
    const double atNodes = std::min(graph.nodeRadiusMm[static_cast<std::size_t>(edge.startNode)],
                                    graph.nodeRadiusMm[static_cast<std::size_t>(edge.endNode)]);
    return *std::min_element(edge.radiusMm.begin(), edge.radiusMm.end()) / atNodes;
}

int representative(std::vector<int>& parents, int node)
{
    while (parents[static_cast<std::size_t>(node)] != node) {
        int& up = parents[static_cast<std::size_t>(node)];
        up = parents[static_cast<std::size_t>(up)];
        node = up;
    }
    return node;
}

int addEnd(VesselGraph& graph, const VesselEdge& edge, std::size_t point)
{
    graph.nodesMm.push_back(edge.pointsMm[point]);
    graph.nodeRadiusMm.push_back(edge.radiusMm[point]);
    return static_cast<int>(graph.nodesMm.size()) - 1;
}

/// Cuts an edge at its thinnest point and adds both halves without that point; drops single-point halves.
void addHalves(VesselGraph& graph, const VesselEdge& edge)
{
    const std::size_t cut = thinnestPoint(edge);
    const auto take = [&](std::size_t from, std::size_t to) {
        const auto first = static_cast<std::ptrdiff_t>(from);
        const auto last = static_cast<std::ptrdiff_t>(to);
        VesselEdge half = edge;
        half.pointsMm.assign(edge.pointsMm.begin() + first, edge.pointsMm.begin() + last);
        half.radiusMm.assign(edge.radiusMm.begin() + first, edge.radiusMm.begin() + last);
        return half;
    };
    if (cut >= 2) {
        VesselEdge half = take(0, cut);
        half.endNode = addEnd(graph, edge, cut - 1);
        graph.edges.push_back(std::move(half));
    }
    if (cut + 2 < edge.pointsMm.size()) {
        VesselEdge half = take(cut + 1, edge.pointsMm.size());
        half.startNode = addEnd(graph, edge, cut + 1);
        graph.edges.push_back(std::move(half));
    }
}

/// Path lengths along a forest.
class ForestPaths {
public:
    explicit ForestPaths(const VesselGraph& forest) : forest_(forest), edgesByNode_(forest.edgesByNode()) {}

    /// Returns the path length between two nodes, or `limitMm` if they are not connected.
    double lengthMm(int from, int to, double limitMm) const
    {
        std::vector<double> distances(forest_.nodesMm.size(), -1.0);
        std::vector<int> reached{from};
        distances[static_cast<std::size_t>(from)] = 0.0;
        for (std::size_t n = 0; n < reached.size(); ++n) {
            const auto node = static_cast<std::size_t>(reached[n]);
            if (reached[n] == to) {
                return distances[node];
            }
            for (const std::size_t e : edgesByNode_[node]) {
                const VesselEdge& edge = forest_.edges[e];
                const int next = edge.startNode == reached[n] ? edge.endNode : edge.startNode;
                double& distance = distances[static_cast<std::size_t>(next)];
                if (distance < 0.0) {
                    distance = distances[node] + edge.lengthMm();
                    reached.push_back(next);
                }
            }
        }
        return limitMm;
    }

private:
    const VesselGraph& forest_;
    std::vector<std::vector<std::size_t>> edgesByNode_;
};

}   // namespace

std::vector<VesselEdge> extractClosingEdges(VesselGraph& graph)
{
    std::vector<VesselEdge> edges = std::move(graph.edges);
    graph.edges.clear();
    std::vector<double> widths;
    widths.reserve(edges.size());
    for (const VesselEdge& edge : edges) {
        widths.push_back(relativeWidth(graph, edge));
    }
    std::vector<std::size_t> order(edges.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return widths[a] > widths[b]; });

    std::vector<int> parents(graph.nodesMm.size());
    std::iota(parents.begin(), parents.end(), 0);
    std::vector<VesselEdge> closing;
    for (const std::size_t e : order) {
        const int start = representative(parents, edges[e].startNode);
        const int end = representative(parents, edges[e].endNode);
        if (start == end) {
            closing.push_back(std::move(edges[e]));
        } else {
            parents[static_cast<std::size_t>(start)] = end;
            graph.edges.push_back(std::move(edges[e]));
        }
    }
    return closing;
}

int openLoops(VesselGraph& graph)
{
    const std::vector<VesselEdge> closing = extractClosingEdges(graph);
    for (const VesselEdge& edge : closing) {
        addHalves(graph, edge);
    }
    return static_cast<int>(closing.size());
}

LoopCount openSmallLoops(VesselGraph& graph, double minLengthMm, TracingProgress& progress)
{
    const std::vector<VesselEdge> closing = extractClosingEdges(graph);
    const VesselGraph forest = graph;
    const ForestPaths distances(forest);
    LoopCount loops;
    for (const VesselEdge& edge : closing) {
        if (!progress.advance(0.0)) {
            break;
        }
        const double widestMm = *std::max_element(edge.radiusMm.begin(), edge.radiusMm.end());
        const double minMm = minLengthMm + 2.0 * std::numbers::pi * widestMm;
        if (edge.lengthMm() + distances.lengthMm(edge.startNode, edge.endNode, minMm) >= minMm) {
            graph.edges.push_back(edge);
            ++loops.kept;
        } else {
            addHalves(graph, edge);
            ++loops.opened;
        }
    }
    return loops;
}

}   // namespace angiopose::core
