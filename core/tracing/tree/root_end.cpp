#include "core/tracing/tree/root_end.h"

#include "core/support/quantile.h"
#include "core/tracing/tree/edge_takeoff.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double equalityToleranceMm = 1e-9;   ///< mm; smaller differences are treated as equal
/// Maximum width of a spur relative to the vessel at whose end it lies; a coronary artery has 0.15 of the aortic width.
constexpr double maxSpurWidthRatio = 0.3;

/// Score of an end as a candidate for the root.
struct RootScore {
    double first = -std::numeric_limits<double>::infinity();
    double second = 0.0;   ///< decides between ends with equal first scores

    bool isBetterThan(const RootScore& other) const
    {
        return first > other.first + equalityToleranceMm ||
               (first > other.first - equalityToleranceMm && second > other.second + equalityToleranceMm);
    }
};

class RootFinder {
public:
    RootFinder(const VesselGraph& graph, const std::vector<std::vector<std::size_t>>& edgesByNode)
        : graph_(graph), edgesByNode_(edgesByNode)
    {
    }

    int bestAmong(const std::vector<int>& nodes, const std::optional<Eigen::Vector3d>& rootMm) const
    {
        int best = -1;
        RootScore bestScore;
        for (const int node : nodes) {
            const std::vector<std::size_t>& edges = edgesByNode_[static_cast<std::size_t>(node)];
            if (edges.size() != 1) {
                continue;
            }
            const RootScore score = rootMm
                                        ? RootScore{-(graph_.nodesMm[static_cast<std::size_t>(node)] - *rootMm).norm()}
                                        : scoreOf(edges.front(), node);
            if (score.isBetterThan(bestScore)) {
                bestScore = score;
                best = node;
            }
        }
        return best;
    }

private:
    double nodeRadius(int node) const { return graph_.nodeRadiusMm[static_cast<std::size_t>(node)]; }

    /// Scores an end by the median width of the vessel that ends there. The end edge may be a spur: a stump on the wall
    /// of a wide vessel, which does not count, or a coronary artery at the aortic root, which ends with the aorta.
    RootScore scoreOf(std::size_t endEdge, int endNode) const
    {
        const VesselEdge fromEnd = graph_.leaving(endEdge, endNode);
        double width = widthOf(endEdge);
        std::size_t edge = endEdge;
        int node = fromEnd.endNode;
        for (std::size_t n = 0; n < graph_.edges.size(); ++n) {
            const std::optional<std::size_t> wide = wideEdgeAmongSpurs(node, edge);
            if (!wide) {
                break;
            }
            edge = *wide;
            node = graph_.leaving(edge, node).endNode;
            width = std::max(width, widthOf(edge));
        }
        return {width, measureTakeoff(fromEnd, nodeRadius(endNode)).radiusMm};
    }

    /// Returns the median radius of an edge; for an edge with a free end, without the part inside the vessel it joins.
    double widthOf(std::size_t e) const
    {
        const bool endsFree = edgesByNode_[static_cast<std::size_t>(graph_.edges[e].endNode)].size() == 1;
        const VesselEdge edge = graph_.leaving(e, endsFree ? graph_.edges[e].endNode : graph_.edges[e].startNode);
        const bool isEnd = edgesByNode_[static_cast<std::size_t>(edge.startNode)].size() == 1;
        const Eigen::Vector3d& junction = edge.pointsMm.back();
        std::vector<double> radii{edge.radiusMm.front()};
        for (std::size_t i = 1; i < edge.pointsMm.size(); ++i) {
            if (!isEnd || (edge.pointsMm[i] - junction).norm() > nodeRadius(edge.endNode)) {
                radii.push_back(edge.radiusMm[i]);
            }
        }
        return medianOf(std::move(radii));
    }

    /// Returns the only wide vessel that ends at the node if `arriving` and all other edges there are thin spurs.
    std::optional<std::size_t> wideEdgeAmongSpurs(int node, std::size_t arriving) const
    {
        std::optional<std::size_t> widest;
        double widestMm = 0.0;
        double nextMm = 0.0;
        for (const std::size_t e : edgesByNode_[static_cast<std::size_t>(node)]) {
            const double width = widthOf(e);
            nextMm = std::max(nextMm, std::min(width, widestMm));
            if (width > widestMm) {
                widestMm = width;
                widest = e;
            }
        }
        return widest != arriving && nextMm < maxSpurWidthRatio * widestMm ? widest : std::nullopt;
    }

    const VesselGraph& graph_;
    const std::vector<std::vector<std::size_t>>& edgesByNode_;   ///< edge indices by node
};

}   // namespace

int findRootEnd(const VesselGraph& graph, const std::vector<std::vector<std::size_t>>& edgesByNode,
                const std::vector<int>& nodes, const std::optional<Eigen::Vector3d>& rootMm)
{
    return RootFinder(graph, edgesByNode).bestAmong(nodes, rootMm);
}

}   // namespace angiopose::core
