#include "core/tracing/tree/close_gaps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace angiopose::core {
namespace {

constexpr double maxGapVoxels = 2.0;   ///< maximum gap for vessels of any width

/// Limits for one gap width: the wider the gap, the straighter the vessel must continue. `minDirection` is the cosine
/// of the angle between the line across the gap and either vessel.
struct GapLimit {
    double widths;
    double minDirection;
    double clearance;   ///< minimum distance to the next free end, relative to the gap
};
constexpr GapLimit narrowGap{2.0, 0.8, 1.0};
constexpr GapLimit wideGap{4.0, 0.9, 1.5};

constexpr double minWidthRatio = 0.5;   ///< minimum width of the thinner end relative to the wider one
constexpr double directionInRadii = 4.0;   ///< length of the end segment that defines its direction
constexpr double directionVoxels = 5.0;
constexpr double tipInRadii = 2.0;   ///< length at the tip over which the maximum radius is taken

struct FreeEnd {
    int node = 0;
    int component = 0;
    Eigen::Vector3d positionMm = Eigen::Vector3d::Zero();
    Eigen::Vector3d outwardDirection = Eigen::Vector3d::Zero();
    double radiusMm = 0.0;
};

/// Nearest end of another component, its distance, and the distance of the second nearest end.
struct Partner {
    std::size_t end = 0;
    double distanceMm = std::numeric_limits<double>::max();
    double secondDistanceMm = std::numeric_limits<double>::max();
};

std::vector<int> componentsByNode(const VesselGraph& graph, const std::vector<std::vector<std::size_t>>& nodeEdges)
{
    std::vector<int> component(graph.nodesMm.size(), -1);
    std::vector<int> pending;
    for (int first = 0; first < static_cast<int>(component.size()); ++first) {
        if (component[static_cast<std::size_t>(first)] >= 0) {
            continue;
        }
        component[static_cast<std::size_t>(first)] = first;
        pending.assign(1, first);
        while (!pending.empty()) {
            const int node = pending.back();
            pending.pop_back();
            for (const std::size_t e : nodeEdges[static_cast<std::size_t>(node)]) {
                const VesselEdge& edge = graph.edges[e];
                const int next = edge.startNode == node ? edge.endNode : edge.startNode;
                if (component[static_cast<std::size_t>(next)] < 0) {
                    component[static_cast<std::size_t>(next)] = first;
                    pending.push_back(next);
                }
            }
        }
    }
    return component;
}

FreeEnd endAt(const VesselGraph& graph, std::size_t e, int node, double voxelMm)
{
    const VesselEdge way = graph.leaving(e, node);
    FreeEnd end{node, 0, way.pointsMm.front(), {}, 0.0};
    end.radiusMm = *std::max_element(
        way.radiusMm.begin(),
        way.radiusMm.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(way.radiusMm.size(), 3)));
    const double reachMm = std::max(directionInRadii * end.radiusMm, directionVoxels * voxelMm);
    std::size_t last = 1;
    while (last + 1 < way.pointsMm.size() && (way.pointsMm[last] - end.positionMm).norm() < reachMm) {
        ++last;
    }
    for (std::size_t n = 0; n <= last; ++n) {
        if ((way.pointsMm[n] - end.positionMm).norm() <= tipInRadii * end.radiusMm) {
            end.radiusMm = std::max(end.radiusMm, way.radiusMm[n]);
        }
    }
    end.outwardDirection = (end.positionMm - way.pointsMm[last]).normalized();
    return end;
}

std::vector<FreeEnd> freeEnds(const VesselGraph& graph, double voxelMm)
{
    const std::vector<std::vector<std::size_t>> nodeEdges = graph.edgesByNode();
    const std::vector<int> component = componentsByNode(graph, nodeEdges);
    std::vector<FreeEnd> ends;
    for (std::size_t node = 0; node < nodeEdges.size(); ++node) {
        if (nodeEdges[node].size() == 1) {
            ends.push_back(endAt(graph, nodeEdges[node].front(), static_cast<int>(node), voxelMm));
            ends.back().component = component[node];
        }
    }
    return ends;
}

bool isWithin(const GapLimit& limit, double gapInWidths, double direction, double clearance)
{
    return gapInWidths <= limit.widths && direction >= limit.minDirection && clearance >= limit.clearance;
}

/// Returns the wall-to-wall distance if a vessel clearly continues across the gap, otherwise nullopt. `clearance` is
/// the distance to the next free end relative to the gap.
std::optional<double> closableGapMm(const FreeEnd& from, const FreeEnd& to, double clearance, double voxelMm)
{
    const Eigen::Vector3d way = to.positionMm - from.positionMm;
    const double thinner = std::min(from.radiusMm, to.radiusMm);
    if (thinner < minWidthRatio * std::max(from.radiusMm, to.radiusMm) || way.norm() < 1e-9) {
        return std::nullopt;
    }
    const double wallGapMm = std::max(0.0, way.norm() - from.radiusMm - to.radiusMm);   // thinning shortens the ends
    const double direction =
        std::min(from.outwardDirection.dot(way.normalized()), -to.outwardDirection.dot(way.normalized()));
    const double gapInWidths = wallGapMm <= maxGapVoxels * voxelMm ? 0.0 : wallGapMm / (2.0 * thinner);
    const bool isClear =
        isWithin(narrowGap, gapInWidths, direction, clearance) || isWithin(wideGap, gapInWidths, direction, clearance);
    return isClear ? std::optional(wallGapMm) : std::nullopt;
}

std::vector<Partner> findPartners(const std::vector<FreeEnd>& ends, TracingProgress& progress)
{
    std::vector<Partner> partners(ends.size(), {ends.size()});
    for (std::size_t a = 0; a < ends.size() && progress.advance(0.0); ++a) {
        Partner& partner = partners[a];
        for (std::size_t b = 0; b < ends.size(); ++b) {
            const double distanceMm = (ends[a].positionMm - ends[b].positionMm).norm();
            if (ends[a].component != ends[b].component && distanceMm < partner.distanceMm) {
                partner = {b, distanceMm, partner.distanceMm};
            } else if (ends[a].component != ends[b].component) {
                partner.secondDistanceMm = std::min(partner.secondDistanceMm, distanceMm);
            }
        }
    }
    return partners;
}

/// Returns a straight edge between two ends.
VesselEdge bridge(const FreeEnd& from, const FreeEnd& to, double voxelMm)
{
    VesselEdge edge{from.node, to.node, {}, {}};
    const double lengthMm = (to.positionMm - from.positionMm).norm();
    const int steps = std::max(1, static_cast<int>(std::ceil(lengthMm / voxelMm)));
    for (int n = 0; n <= steps; ++n) {
        const double fraction = static_cast<double>(n) / steps;
        edge.pointsMm.emplace_back((1.0 - fraction) * from.positionMm + fraction * to.positionMm);
        edge.radiusMm.push_back((1.0 - fraction) * from.radiusMm + fraction * to.radiusMm);
    }
    return edge;
}

}   // namespace

ClosedGaps closeClearGaps(VesselGraph& graph, double voxelMm, TracingProgress& progress)
{
    ClosedGaps closed;
    const std::vector<FreeEnd> ends = freeEnds(graph, voxelMm);
    const std::vector<Partner> partners = findPartners(ends, progress);
    std::vector<int> parents;
    for (std::size_t node = 0; node < graph.nodesMm.size(); ++node) {
        parents.push_back(static_cast<int>(node));
    }
    const auto findComponent = [&parents](int component) {
        while (parents[static_cast<std::size_t>(component)] != component) {
            component = parents[static_cast<std::size_t>(component)];
        }
        return component;
    };
    for (std::size_t a = 0; a < ends.size() && !progress.isStopped(); ++a) {
        const std::size_t b = partners[a].end;
        if (b >= ends.size() || b < a || partners[b].end != a ||
            findComponent(ends[a].component) == findComponent(ends[b].component)) {
            continue;
        }
        const double clearance = std::min(partners[a].secondDistanceMm, partners[b].secondDistanceMm) /
                                 std::max(1e-9, partners[a].distanceMm);
        if (const auto gapMm = closableGapMm(ends[a], ends[b], clearance, voxelMm)) {
            graph.edges.push_back(bridge(ends[a], ends[b], voxelMm));
            parents[static_cast<std::size_t>(findComponent(ends[b].component))] = findComponent(ends[a].component);
            ++closed.count;
            closed.maxGapMm = std::max(closed.maxGapMm, *gapMm);
        }
    }
    return closed;
}

}   // namespace angiopose::core
