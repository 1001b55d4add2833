#include "core/registration/pnp/traced_path.h"

#include <algorithm>
#include <optional>

namespace angiopose::core {
namespace {

constexpr double muchShorter = 0.75;
constexpr double muchLonger = 1.33;
constexpr double headingPx = 20.0;   // length over which a direction is measured
constexpr double minStraightCosine = 0.7071;   // cosine of 45°

/// Returns the unit direction at the start of a polyline; nullopt if all points coincide.
std::optional<Eigen::Vector2d> headingOf(const std::vector<Eigen::Vector2d>& points)
{
    const Eigen::Vector2d chord = pointAtLength(points, headingPx) - points.front();
    return chord.norm() > 0.0 ? std::optional<Eigen::Vector2d>(chord.normalized()) : std::nullopt;
}

std::vector<Eigen::Vector2d> pointsAlong(const BranchGraph& graph, const TargetSamples& target, const EdgeEnd& way)
{
    const BranchEdge& edge = graph.edges[static_cast<std::size_t>(way.edge)];
    std::vector<Eigen::Vector2d> points(target.points.begin() + static_cast<std::ptrdiff_t>(edge.from),
                                        target.points.begin() + static_cast<std::ptrdiff_t>(edge.to));
    if (way.isReversed) {
        std::ranges::reverse(points);
    }
    return points;
}

/// Returns the edge that continues the path at its final node with the smallest change of direction, at most 45°.
std::optional<EdgeEnd> straightContinuation(const BranchGraph& graph, const TargetSamples& target,
                                            const TracedPath& path)
{
    const std::vector<Eigen::Vector2d> backwards(path.points.rbegin(), path.points.rend());
    const auto back = headingOf(backwards);
    std::optional<EdgeEnd> best;
    double bestCosine = minStraightCosine;
    for (const EdgeEnd& way : graph.nodes[static_cast<std::size_t>(path.endNode)]) {
        if (!back || std::ranges::find(path.edges, way.edge) != path.edges.end()) {
            continue;
        }
        const auto heading = headingOf(pointsAlong(graph, target, way));
        const double cosine = heading ? -heading->dot(*back) : -1.0;
        if (cosine > bestCosine) {
            bestCosine = cosine;
            best = way;
        }
    }
    return best;
}

}   // namespace

double lengthOf(const std::vector<Eigen::Vector2d>& points)
{
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        length += (points[i] - points[i - 1]).norm();
    }
    return length;
}

Eigen::Vector2d pointAtLength(const std::vector<Eigen::Vector2d>& points, double alongPx)
{
    double left = std::max(0.0, alongPx);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double piece = (points[i] - points[i - 1]).norm();
        if (left <= piece && piece > 0.0) {
            return points[i - 1] + left / piece * (points[i] - points[i - 1]);
        }
        left -= piece;
    }
    return points.back();
}

TracedPath followPath(const BranchGraph& graph, const TargetSamples& target, EdgeEnd way, double maxLengthPx)
{
    TracedPath path;
    for (std::optional<EdgeEnd> next = way; next;) {
        const std::vector<Eigen::Vector2d> more = pointsAlong(graph, target, *next);
        path.points.insert(path.points.end(), more.begin(), more.end());
        path.edges.push_back(next->edge);
        path.endNode = graph.targetNode(*next);
        path.lengthPx = lengthOf(path.points);
        next = path.lengthPx < muchShorter * maxLengthPx ? straightContinuation(graph, target, path) : std::nullopt;
    }
    if (path.lengthPx > muchLonger * maxLengthPx) {
        path.endNode = TracedPath::noNode;
        path.lengthPx = maxLengthPx;
    }
    return path;
}

}   // namespace angiopose::core
