#include "core/tracing/tree/prune_spurs.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double neverRemoved = std::numeric_limits<double>::infinity();

/// Part of a spur outside the parent's wall, up to the tip of the spur.
struct Protrusion {
    double lengthMm = 0.0;
    double radiusMm = 0.0;
};

Protrusion protrusionOf(const VesselEdge& fromParent, double parentRadiusMm)
{
    const Eigen::Vector3d& start = fromParent.pointsMm.front();
    Protrusion result;
    double radiusSum = 0.0;
    std::size_t outside = 0;
    for (std::size_t i = 1; i < fromParent.pointsMm.size(); ++i) {
        if ((fromParent.pointsMm[i] - start).norm() > parentRadiusMm) {
            result.lengthMm += (fromParent.pointsMm[i] - fromParent.pointsMm[i - 1]).norm();
            radiusSum += fromParent.radiusMm[i];
            ++outside;
        }
    }
    result.lengthMm += outside > 0 ? fromParent.radiusMm.back() : 0.0;
    result.radiusMm = outside > 0 ? radiusSum / static_cast<double>(outside) : fromParent.radiusMm.back();
    return result;
}

/// Removes and joins edges, keeping track of the edges at each node and the score of each spur.
class SpurPruner {
public:
    SpurPruner(VesselGraph& graph, const SpurLimits& limits)
        : graph_(graph), limits_(limits), edgesByNode_(graph.edgesByNode()), scores_(graph.edges.size(), neverRemoved)
    {
    }

    void mergeAll()
    {
        for (int node = 0; node < static_cast<int>(graph_.nodesMm.size()); ++node) {
            mergeEdgesAt(node);
        }
    }

    void prune(TracingProgress& progress)
    {
        for (std::size_t e = 0; e < graph_.edges.size() && progress.advance(0.0); ++e) {
            if (!isRemoved(e)) {
                setScore(e, scoreOf(e));
            }
        }
        while (!spurs_.empty() && progress.advance(0.0)) {
            remove(spurs_.begin()->second);
        }
    }

    void removeEmptyEdges()
    {
        std::erase_if(graph_.edges, [](const VesselEdge& edge) { return edge.pointsMm.empty(); });
    }

private:
    std::vector<std::size_t>& edgesAt(int node) { return edgesByNode_[static_cast<std::size_t>(node)]; }
    const std::vector<std::size_t>& edgesAt(int node) const { return edgesByNode_[static_cast<std::size_t>(node)]; }
    bool isRemoved(std::size_t e) const { return graph_.edges[e].pointsMm.empty(); }

    /// Returns the vessel radius at a node: the largest inscribed sphere around the node, except those in the spur.
    double vesselRadiusAt(int node, std::size_t spur) const
    {
        const Eigen::Vector3d& center = graph_.nodesMm[static_cast<std::size_t>(node)];
        const double around = graph_.nodeRadiusMm[static_cast<std::size_t>(node)];
        double radius = around;
        for (const std::size_t e : edgesAt(node)) {
            const VesselEdge& edge = graph_.edges[e];
            for (std::size_t i = 0; e != spur && i < edge.pointsMm.size(); ++i) {
                if ((edge.pointsMm[i] - center).norm() < around) {
                    radius = std::max(radius, edge.radiusMm[i]);
                }
            }
        }
        return radius;
    }

    /// Returns the score of an edge: spurs below 1 are removed, lowest first; infinite if the edge is not a spur.
    double scoreOf(std::size_t e) const
    {
        const VesselEdge& edge = graph_.edges[e];
        const bool startsFree = edgesAt(edge.startNode).size() == 1;
        const bool endsFree = edgesAt(edge.endNode).size() == 1;
        if (startsFree && endsFree) {
            return (edge.lengthMm() + edge.radiusMm.front() + edge.radiusMm.back()) / limits_.minLengthMm;
        }
        if (!startsFree && !endsFree) {
            return neverRemoved;
        }
        const VesselEdge fromParent = endsFree ? edge : reversed(edge);
        const Protrusion protrusion = protrusionOf(fromParent, vesselRadiusAt(fromParent.startNode, e));
        const double requiredMm = std::max(limits_.minLengthMm, limits_.minLengthInRadii * protrusion.radiusMm);
        return protrusion.radiusMm < limits_.minRadiusMm ? 0.0 : protrusion.lengthMm / requiredMm;
    }

    void remove(std::size_t e)
    {
        const int start = graph_.edges[e].startNode;
        const int end = graph_.edges[e].endNode;
        erase(e);
        for (const int node : {start, end}) {
            mergeEdgesAt(node);
            for (const std::size_t touched : edgesAt(node)) {
                setScore(touched, scoreOf(touched));
            }
        }
    }

    void erase(std::size_t e)
    {
        std::erase(edgesAt(graph_.edges[e].startNode), e);
        std::erase(edgesAt(graph_.edges[e].endNode), e);
        graph_.edges[e] = {};
        setScore(e, neverRemoved);
    }

    /// Updates the score of an edge in the removal queue (lowest first, ties by index).
    void setScore(std::size_t e, double score)
    {
        spurs_.erase({scores_[e], e});
        scores_[e] = score;
        if (score < 1.0) {
            spurs_.emplace(score, e);
        }
    }

    /// Joins the edges at `node` into the first one if exactly two different edges meet there.
    void mergeEdgesAt(int node)
    {
        const std::vector<std::size_t> pair = edgesAt(node);
        if (pair.size() != 2 || pair[0] == pair[1]) {
            return;
        }
        VesselEdge first = graph_.edges[pair[0]];
        VesselEdge second = graph_.edges[pair[1]];
        erase(pair[0]);
        erase(pair[1]);
        first = first.endNode == node ? first : reversed(std::move(first));
        second = second.startNode == node ? second : reversed(std::move(second));
        first.endNode = second.endNode;
        first.pointsMm.insert(first.pointsMm.end(), second.pointsMm.begin() + 1, second.pointsMm.end());
        first.radiusMm.insert(first.radiusMm.end(), second.radiusMm.begin() + 1, second.radiusMm.end());
        edgesAt(first.startNode).push_back(pair[0]);
        edgesAt(first.endNode).push_back(pair[0]);
        graph_.edges[pair[0]] = std::move(first);
        setScore(pair[0], scoreOf(pair[0]));
    }

    VesselGraph& graph_;
    const SpurLimits& limits_;
    std::vector<std::vector<std::size_t>> edgesByNode_;   ///< edges by node; an edge from a node to itself counts twice
    std::vector<double> scores_;
    std::set<std::pair<double, std::size_t>> spurs_;   ///< score (below 1) and edge index of each spur
};

}   // namespace

void pruneSpurs(VesselGraph& graph, const SpurLimits& limits, TracingProgress& progress)
{
    SpurPruner pruner(graph, limits);
    pruner.mergeAll();
    pruner.prune(progress);
    pruner.removeEmptyEdges();
}

}   // namespace angiopose::core
