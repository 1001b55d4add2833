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
constexpr GapLimit narrow{2.0, 0.8, 1.0};
constexpr GapLimit wide{4.0, 0.9, 1.5};

constexpr double minWidthShare = 0.5;   ///< minimum width of the thinner end relative to the wider one
constexpr double directionInRadii = 4.0;   ///< length of the end segment that defines its direction
constexpr double directionVoxels = 5.0;
constexpr double tipInRadii = 2.0;   ///< length at the tip over which the maximum radius is taken

struct FreeEnd {
    int node = 0;
    int piece = 0;
    Eigen::Vector3d placeMm = Eigen::Vector3d::Zero();
    Eigen::Vector3d outwards = Eigen::Vector3d::Zero();
    double radiusMm = 0.0;
};

/// Nearest end of another component, its distance, and the distance of the second nearest end.
struct Partner {
    std::size_t end = 0;
    double awayMm = std::numeric_limits<double>::max();
    double nextMm = std::numeric_limits<double>::max();
};

std::vector<int> piecesByNode(const VesselGraph& graph, const std::vector<std::vector<std::size_t>>& meeting)
{
    std::vector<int> piece(graph.nodesMm.size(), -1);
    std::vector<int> waiting;
    for (int first = 0; first < static_cast<int>(piece.size()); ++first) {
        if (piece[static_cast<std::size_t>(first)] >= 0) {
            continue;
        }
        piece[static_cast<std::size_t>(first)] = first;
        waiting.assign(1, first);
        while (!waiting.empty()) {
            const int node = waiting.back();
            waiting.pop_back();
            for (const std::size_t e : meeting[static_cast<std::size_t>(node)]) {
                const VesselEdge& edge = graph.edges[e];
                const int next = edge.startNode == node ? edge.endNode : edge.startNode;
                if (piece[static_cast<std::size_t>(next)] < 0) {
                    piece[static_cast<std::size_t>(next)] = first;
                    waiting.push_back(next);
                }
            }
        }
    }
    return piece;
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
    while (last + 1 < way.pointsMm.size() && (way.pointsMm[last] - end.placeMm).norm() < reachMm) {
        ++last;
    }
    for (std::size_t n = 0; n <= last; ++n) {
        if ((way.pointsMm[n] - end.placeMm).norm() <= tipInRadii * end.radiusMm) {
            end.radiusMm = std::max(end.radiusMm, way.radiusMm[n]);
        }
    }
    end.outwards = (end.placeMm - way.pointsMm[last]).normalized();
    return end;
}

std::vector<FreeEnd> freeEnds(const VesselGraph& graph, double voxelMm)
{
    const std::vector<std::vector<std::size_t>> meeting = graph.edgesByNode();
    const std::vector<int> piece = piecesByNode(graph, meeting);
    std::vector<FreeEnd> ends;
    for (std::size_t node = 0; node < meeting.size(); ++node) {
        if (meeting[node].size() == 1) {
            ends.push_back(endAt(graph, meeting[node].front(), static_cast<int>(node), voxelMm));
            ends.back().piece = piece[node];
        }
    }
    return ends;
}

bool isWithin(const GapLimit& limit, double gapInWidths, double direction, double clearance)
{
    return gapInWidths <= limit.widths && direction >= limit.minDirection && clearance >= limit.clearance;
}

/// Returns the wall-to-wall distance if a vessel clearly continues across the gap, else nullopt. `clearance` is the
/// distance to the next free end relative to the gap.
std::optional<double> clearGapMm(const FreeEnd& from, const FreeEnd& to, double clearance, double voxelMm)
{
    const Eigen::Vector3d way = to.placeMm - from.placeMm;
    const double thinner = std::min(from.radiusMm, to.radiusMm);
    if (thinner < minWidthShare * std::max(from.radiusMm, to.radiusMm) || way.norm() < 1e-9) {
        return std::nullopt;
    }
    const double wallsMm = std::max(0.0, way.norm() - from.radiusMm - to.radiusMm);   // thinning shortens the ends
    const double direction = std::min(from.outwards.dot(way.normalized()), -to.outwards.dot(way.normalized()));
    const double gapInWidths = wallsMm <= maxGapVoxels * voxelMm ? 0.0 : wallsMm / (2.0 * thinner);
    const bool isClear =
        isWithin(narrow, gapInWidths, direction, clearance) || isWithin(wide, gapInWidths, direction, clearance);
    return isClear ? std::optional(wallsMm) : std::nullopt;
}

std::vector<Partner> partnersOf(const std::vector<FreeEnd>& ends, TracingProgress& progress)
{
    std::vector<Partner> partners(ends.size(), {ends.size()});
    for (std::size_t a = 0; a < ends.size() && progress.advance(0.0); ++a) {
        Partner& partner = partners[a];
        for (std::size_t b = 0; b < ends.size(); ++b) {
            const double awayMm = (ends[a].placeMm - ends[b].placeMm).norm();
            if (ends[a].piece != ends[b].piece && awayMm < partner.awayMm) {
                partner = {b, awayMm, partner.awayMm};
            } else if (ends[a].piece != ends[b].piece) {
                partner.nextMm = std::min(partner.nextMm, awayMm);
            }
        }
    }
    return partners;
}

/// Creates a straight edge between two ends.
VesselEdge bridge(const FreeEnd& from, const FreeEnd& to, double voxelMm)
{
    VesselEdge edge{from.node, to.node, {}, {}};
    const double lengthMm = (to.placeMm - from.placeMm).norm();
    const int steps = std::max(1, static_cast<int>(std::ceil(lengthMm / voxelMm)));
    for (int n = 0; n <= steps; ++n) {
        const double share = static_cast<double>(n) / steps;
        edge.pointsMm.emplace_back((1.0 - share) * from.placeMm + share * to.placeMm);
        edge.radiusMm.push_back((1.0 - share) * from.radiusMm + share * to.radiusMm);
    }
    return edge;
}

}   // namespace

ClosedGaps closeClearGaps(VesselGraph& graph, double voxelMm, TracingProgress& progress)
{
    ClosedGaps closed;
    const std::vector<FreeEnd> ends = freeEnds(graph, voxelMm);
    const std::vector<Partner> partners = partnersOf(ends, progress);
    std::vector<int> above;
    for (std::size_t node = 0; node < graph.nodesMm.size(); ++node) {
        above.push_back(static_cast<int>(node));
    }
    const auto pieceOf = [&above](int piece) {
        while (above[static_cast<std::size_t>(piece)] != piece) {
            piece = above[static_cast<std::size_t>(piece)];
        }
        return piece;
    };
    for (std::size_t a = 0; a < ends.size() && !progress.isStopped(); ++a) {
        const std::size_t b = partners[a].end;
        if (b >= ends.size() || b < a || partners[b].end != a || pieceOf(ends[a].piece) == pieceOf(ends[b].piece)) {
            continue;
        }
        const double clearance = std::min(partners[a].nextMm, partners[b].nextMm) / std::max(1e-9, partners[a].awayMm);
        if (const auto gapMm = clearGapMm(ends[a], ends[b], clearance, voxelMm)) {
            graph.edges.push_back(bridge(ends[a], ends[b], voxelMm));
            above[static_cast<std::size_t>(pieceOf(ends[b].piece))] = pieceOf(ends[a].piece);
            ++closed.count;
            closed.longestMm = std::max(closed.longestMm, *gapMm);
        }
    }
    return closed;
}

}   // namespace angiopose::core
