#include "core/tracing/tree/dim_subtrees.h"

#include "core/support/quantile.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double minOpacificationOfStart = 0.65;   ///< blurring alone leaves 0.8 in the thinnest evaluated vessels
constexpr double minRadius = 1.5;   ///< in voxels; blurring dims the center of thinner vessels
constexpr double minWideShare = 0.5;   ///< minimum fraction of an edge's points wide enough to evaluate
constexpr std::size_t minWide = 6;   ///< minimum number of evaluable points
constexpr double exemptRadiusMm = 25.0;   ///< exempt radius around the starts: false lumens of dissections are dim
constexpr double minSectionConfidence = 0.5;   ///< minimum confidence in a cross-section
constexpr std::size_t partTangentReach = 3;   ///< points on either side for the tangent

/// Returns the opacification at a point of an edge; nullopt if the vessel is too thin. Masks of faint lumens have
/// holes, which shrink the inscribed spheres and shift the skeleton off the centerline; the cross-section corrects
/// both.
std::optional<double> opacificationWhereWide(const VesselEdge& edge, std::size_t n,
                                             const PointOpacification& opacification, double voxelMm)
{
    const std::size_t before = n - std::min(n, partTangentReach);
    const std::size_t after = std::min(n + partTangentReach, edge.pointsMm.size() - 1);
    const Eigen::Vector3d chord = edge.pointsMm[after] - edge.pointsMm[before];
    double radiusMm = edge.radiusMm[n];
    Eigen::Vector3d axisPointMm = edge.pointsMm[n];
    if (!chord.isZero()) {
        const CrossSection section =
            measureCrossSection({axisPointMm, chord.normalized(), std::max(radiusMm, voxelMm), voxelMm}, opacification);
        if (section.confidence >= minSectionConfidence) {
            radiusMm = section.radiusMm;
            axisPointMm = section.centerMm;
        }
    }
    return radiusMm >= minRadius * voxelMm ? std::optional(opacification(axisPointMm)) : std::nullopt;
}

/// Returns the median opacification of an edge if most of the edge is wide enough to evaluate, otherwise nullopt.
std::optional<double> medianFill(const VesselEdge& edge, const PointOpacification& opacification, double voxelMm)
{
    std::vector<double> fills;
    for (std::size_t n = 0; n < edge.pointsMm.size(); ++n) {
        if (const auto here = opacificationWhereWide(edge, n, opacification, voxelMm)) {
            fills.push_back(*here);
        }
    }
    if (fills.size() < minWide ||
        static_cast<double>(fills.size()) < minWideShare * static_cast<double>(edge.pointsMm.size())) {
        return std::nullopt;
    }
    return medianOf(std::move(fills));
}

bool isNearStart(const VesselEdge& edge, const std::vector<Eigen::Vector3d>& startsMm)
{
    const Eigen::Vector3d& middle = edge.pointsMm[edge.pointsMm.size() / 2];
    return std::ranges::any_of(startsMm,
                               [&](const Eigen::Vector3d& start) { return (start - middle).norm() < exemptRadiusMm; });
}

/// Subtree distal to an edge (seen from the starts), including the edge.
struct Subtree {
    double dimMm = 0.0;
    double opacifiedMm = 0.0;
    bool containsStart = false;
};

class DimSubtrees {
public:
    DimSubtrees(VesselGraph& graph, const PointOpacification& opacification, double voxelMm)
        : graph_(graph), edgesByNode_(graph.edgesByNode()), containsStart_(graph.edges.size(), false)
    {
        for (const VesselEdge& edge : graph.edges) {
            fills_.push_back(medianFill(edge, opacification, voxelMm));
        }
    }

    int drop(const std::vector<Eigen::Vector3d>& startsMm)
    {
        for (const Eigen::Vector3d& start : startsMm) {
            containsStart_[nearestEdge(start)] = true;
        }
        for (std::size_t e = 0; e < fills_.size(); ++e) {
            isNearStart_.push_back(isNearStart(graph_.edges[e], startsMm));
        }
        const std::optional<double> blood = opacificationAtStarts();
        if (!blood) {
            return 0;
        }
        minFill_ = minOpacificationOfStart * *blood;
        const auto first = std::find(containsStart_.begin(), containsStart_.end(), true);
        const VesselEdge& edge = graph_.edges[static_cast<std::size_t>(first - containsStart_.begin())];
        visitFrom(edge.startNode);
        for (std::size_t n = order_.size(); n-- > 0;) {
            accumulateSubtree(n);
        }
        return removeDim();
    }

private:
    std::size_t nearestEdge(const Eigen::Vector3d& placeMm) const
    {
        std::size_t nearest = 0;
        double nearestSquared = std::numeric_limits<double>::max();
        for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
            for (const Eigen::Vector3d& point : graph_.edges[e].pointsMm) {
                if (const double squared = (point - placeMm).squaredNorm(); squared < nearestSquared) {
                    nearestSquared = squared;
                    nearest = e;
                }
            }
        }
        return nearest;
    }

    /// Returns the length-weighted median opacification of the vessels that contain starts.
    std::optional<double> opacificationAtStarts() const
    {
        std::vector<std::pair<double, double>> fillsAndLengths;
        double wholeMm = 0.0;
        for (std::size_t e = 0; e < fills_.size(); ++e) {
            if (containsStart_[e] && fills_[e]) {
                fillsAndLengths.emplace_back(*fills_[e], graph_.edges[e].lengthMm());
                wholeMm += fillsAndLengths.back().second;
            }
        }
        std::sort(fillsAndLengths.begin(), fillsAndLengths.end());
        double passedMm = 0.0;
        for (const auto& [opacification, lengthMm] : fillsAndLengths) {
            passedMm += lengthMm;
            if (2.0 * passedMm >= wholeMm) {
                return opacification;
            }
        }
        return std::nullopt;
    }

    struct Step {
        std::size_t edge = 0;
        int from = 0;   ///< proximal node
        int to = 0;
        std::size_t last = 0;   ///< one past the last step distal to this edge (index into `order_`)
        Subtree subtree;
    };

    /// Visits the edges depth first, so that all edges distal to a step directly follow it in `order_`.
    void visitFrom(int root)
    {
        std::vector<bool> seen(graph_.edges.size(), false);
        std::vector<std::pair<std::size_t, int>> pending;   // edges to visit, with the node each one is entered from
        const auto enqueueEdges = [&](int node) {
            for (const std::size_t e : edgesByNode_[static_cast<std::size_t>(node)]) {
                pending.emplace_back(e, node);
            }
        };
        enqueueEdges(root);
        while (!pending.empty()) {
            const auto [e, from] = pending.back();
            pending.pop_back();
            if (!seen[e]) {
                seen[e] = true;
                const VesselEdge& edge = graph_.edges[e];
                order_.push_back({e, from, edge.startNode == from ? edge.endNode : edge.startNode, 0, {}});
                enqueueEdges(order_.back().to);
            }
        }
    }

    /// Accumulates the subtree of a step from the subtrees of its children, which follow it in `order_`.
    void accumulateSubtree(std::size_t n)
    {
        Step& step = order_[n];
        const double lengthMm = graph_.edges[step.edge].lengthMm();
        step.subtree.containsStart = containsStart_[step.edge];
        if (fills_[step.edge]) {
            (isDim(step.edge) ? step.subtree.dimMm : step.subtree.opacifiedMm) += lengthMm;
        }
        step.last = n + 1;
        while (step.last < order_.size() && order_[step.last].from == step.to) {
            const Step& next = order_[step.last];
            step.subtree.dimMm += next.subtree.dimMm;
            step.subtree.opacifiedMm += next.subtree.opacifiedMm;
            step.subtree.containsStart = step.subtree.containsStart || next.subtree.containsStart;
            step.last = next.last;
        }
    }

    bool isDim(std::size_t e) const { return fills_[e] && *fills_[e] < minFill_ && !isNearStart_[e]; }

    int removeDim()
    {
        int removed = 0;
        for (std::size_t n = 0; n < order_.size();) {
            const Step& step = order_[n];
            const bool isLeak =
                isDim(step.edge) && !step.subtree.containsStart && step.subtree.dimMm > step.subtree.opacifiedMm;
            for (std::size_t gone = n; isLeak && gone < step.last; ++gone) {
                graph_.edges[order_[gone].edge].pointsMm.clear();
            }
            removed += isLeak ? 1 : 0;
            n = isLeak ? step.last : n + 1;
        }
        std::erase_if(graph_.edges, [](const VesselEdge& edge) { return edge.pointsMm.empty(); });
        return removed;
    }

    VesselGraph& graph_;
    std::vector<std::vector<std::size_t>> edgesByNode_;   ///< edge indices by node
    std::vector<bool> containsStart_;
    std::vector<bool> isNearStart_;   ///< whether the edge is near a start
    std::vector<std::optional<double>> fills_;   ///< median opacification per edge; nullopt if too thin to evaluate
    std::vector<Step> order_;
    double minFill_ = 0.0;
};

}   // namespace

int removeDimSubtrees(VesselGraph& graph, const PointOpacification& opacification,
                      const std::vector<Eigen::Vector3d>& startsMm, double voxelMm)
{
    const bool canDecide = !graph.edges.empty() && !startsMm.empty();
    return canDecide ? DimSubtrees(graph, opacification, voxelMm).drop(startsMm) : 0;
}

}   // namespace angiopose::core
