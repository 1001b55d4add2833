#include "core/tracing/tree/prune_spurs.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

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
class Pruner {
public:
    Pruner(VesselGraph& graph, const SpurLimits& limits)
        : graph_(graph), limits_(limits), meeting_(graph.edgesByNode()), worths_(graph.edges.size(), never)
    {
    }

    void joinAll()
    {
        for (int node = 0; node < static_cast<int>(graph_.nodesMm.size()); ++node) {
            joinThrough(node);
        }
    }

    void prune(TracingProgress& progress)
    {
        for (std::size_t e = 0; e < graph_.edges.size() && progress.advance(0.0); ++e) {
            if (!isGone(e)) {
                setWorth(e, worthOf(e));
            }
        }
        while (!spurs_.empty() && progress.advance(0.0)) {
            remove(spurs_.begin()->second);
        }
    }

    void dropGone()
    {
        std::erase_if(graph_.edges, [](const VesselEdge& edge) { return edge.pointsMm.empty(); });
    }

private:
    std::vector<std::size_t>& meetingAt(int node) { return meeting_[static_cast<std::size_t>(node)]; }
    const std::vector<std::size_t>& meetingAt(int node) const { return meeting_[static_cast<std::size_t>(node)]; }
    bool isGone(std::size_t e) const { return graph_.edges[e].pointsMm.empty(); }

    /// Returns the vessel radius at a node: the largest inscribed sphere around the node, except those in the spur.
    double widthAt(int node, std::size_t spur) const
    {
        const Eigen::Vector3d& center = graph_.nodesMm[static_cast<std::size_t>(node)];
        const double around = graph_.nodeRadiusMm[static_cast<std::size_t>(node)];
        double radius = around;
        for (const std::size_t e : meetingAt(node)) {
            const VesselEdge& edge = graph_.edges[e];
            for (std::size_t i = 0; e != spur && i < edge.pointsMm.size(); ++i) {
                if ((edge.pointsMm[i] - center).norm() < around) {
                    radius = std::max(radius, edge.radiusMm[i]);
                }
            }
        }
        return radius;
    }

    /// Scores an edge: spurs below 1 are removed, lowest first; infinite if the edge is not a spur.
    double worthOf(std::size_t e) const
    {
        const VesselEdge& edge = graph_.edges[e];
        const bool startsFree = meetingAt(edge.startNode).size() == 1;
        const bool endsFree = meetingAt(edge.endNode).size() == 1;
        if (startsFree && endsFree) {
            return (edge.lengthMm() + edge.radiusMm.front() + edge.radiusMm.back()) / limits_.minLengthMm;
        }
        if (!startsFree && !endsFree) {
            return never;
        }
        const VesselEdge fromParent = endsFree ? edge : reversed(edge);
        const Protrusion out = protrusionOf(fromParent, widthAt(fromParent.startNode, e));
        const double needed = std::max(limits_.minLengthMm, limits_.minLengthInRadii * out.radiusMm);
        return out.radiusMm < limits_.minRadiusMm ? 0.0 : out.lengthMm / needed;
    }

    void remove(std::size_t e)
    {
        const int start = graph_.edges[e].startNode;
        const int end = graph_.edges[e].endNode;
        erase(e);
        for (const int node : {start, end}) {
            joinThrough(node);
            for (const std::size_t touched : meetingAt(node)) {
                setWorth(touched, worthOf(touched));
            }
        }
    }

    void erase(std::size_t e)
    {
        std::erase(meetingAt(graph_.edges[e].startNode), e);
        std::erase(meetingAt(graph_.edges[e].endNode), e);
        graph_.edges[e] = {};
        setWorth(e, never);
    }

    /// Updates the score of an edge in the removal queue (lowest first, ties by index).
    void setWorth(std::size_t e, double worth)
    {
        spurs_.erase({worths_[e], e});
        worths_[e] = worth;
        if (worth < 1.0) {
            spurs_.emplace(worth, e);
        }
    }

    /// Joins the edges at `node` into the first one if exactly two different edges meet there.
    void joinThrough(int node)
    {
        const std::vector<std::size_t> pair = meetingAt(node);
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
        meetingAt(first.startNode).push_back(pair[0]);
        meetingAt(first.endNode).push_back(pair[0]);
        graph_.edges[pair[0]] = std::move(first);
        setWorth(pair[0], worthOf(pair[0]));
    }

    VesselGraph& graph_;
    const SpurLimits& limits_;
    std::vector<std::vector<std::size_t>> meeting_;   ///< edges by node; an edge from a node to itself counts twice
    std::vector<double> worths_;
    std::set<std::pair<double, std::size_t>> spurs_;   ///< score (below 1) and edge index of each spur
};

}   // namespace

void pruneSpurs(VesselGraph& graph, const SpurLimits& limits, TracingProgress& progress)
{
    Pruner pruner(graph, limits);
    pruner.joinAll();
    pruner.prune(progress);
    pruner.dropGone();
}

}   // namespace angiopose::core
