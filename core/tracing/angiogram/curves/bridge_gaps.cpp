#include "core/tracing/angiogram/curves/bridge_gaps.h"

#include "core/imaging/image_filters.h"
#include "core/imaging/mask_morphology.h"
#include "core/support/parallel_for.h"
#include "core/tracing/angiogram/curves/skeleton_graph.h"
#include "core/tracing/angiogram/curves/thin_mask.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>

namespace angiopose::core {
namespace {

constexpr double minAheadCosine = 0.7;   // cosine of the maximum angle (45°) to the direction of the vessel end
constexpr std::size_t directionReach = 8;

struct FreeEnd {
    Eigen::Vector2d point;
    Eigen::Vector2d direction;
};

std::vector<FreeEnd> findFreeEnds(const SkeletonGraph& graph)
{
    std::vector<int> degrees(graph.nodesPx.size(), 0);
    for (const SkeletonEdge& edge : graph.edges) {
        ++degrees[static_cast<std::size_t>(edge.startNode)];
        ++degrees[static_cast<std::size_t>(edge.endNode)];
    }
    std::vector<FreeEnd> ends;
    for (const SkeletonEdge& edge : graph.edges) {
        const auto& points = edge.pointsPx;
        const std::size_t reach = std::min(directionReach, points.size() - 1);
        if (degrees[static_cast<std::size_t>(edge.startNode)] == 1) {
            ends.push_back({points.front(), (points.front() - points[reach]).normalized()});
        }
        if (degrees[static_cast<std::size_t>(edge.endNode)] == 1) {
            ends.push_back({points.back(), (points.back() - points[points.size() - 1 - reach]).normalized()});
        }
    }
    return ends;
}

Image2d<int> componentLabels(const Mask2d& mask)
{
    Image2d<int> labels(mask.width, mask.height, -1);
    int label = 0;
    for (const std::vector<std::size_t>& component : componentsOf(mask)) {
        for (const std::size_t p : component) {
            labels.pixels[p] = label;
        }
        ++label;
    }
    return labels;
}

/// Returns the nearest pixel of another component that lies ahead of the free end, within `reachPx`.
std::optional<Eigen::Vector2d> targetAhead(const FreeEnd& end, const Image2d<int>& labels, double reachPx)
{
    const int x0 = static_cast<int>(std::lround(end.point.x()));
    const int y0 = static_cast<int>(std::lround(end.point.y()));
    const int reach = static_cast<int>(reachPx);
    std::optional<Eigen::Vector2d> nearest;
    double nearestDistance = reachPx;
    for (int y = y0 - reach; y <= y0 + reach; ++y) {
        for (int x = x0 - reach; x <= x0 + reach; ++x) {
            if (!labels.contains(x, y) || labels.at(x, y) < 0 || labels.at(x, y) == labels.at(x0, y0)) {
                continue;
            }
            const Eigen::Vector2d offset = Eigen::Vector2d(x, y) - end.point;
            const double distance = offset.norm();
            if (distance <= nearestDistance && offset.dot(end.direction) >= minAheadCosine * distance) {
                nearest = Eigen::Vector2d(x, y);
                nearestDistance = distance;
            }
        }
    }
    return nearest;
}

double meanAlong(const ImageF& image, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm())));
    double sum = 0.0;
    for (int k = 0; k <= steps; ++k) {
        const Eigen::Vector2d at = from + (to - from) * k / steps;
        sum += sampleBilinear(image, at.x(), at.y());
    }
    return sum / (steps + 1);
}

void drawLine(Mask2d& mask, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    const int steps = std::max(1, static_cast<int>(std::ceil(2.0 * (to - from).norm())));
    for (int k = 0; k <= steps; ++k) {
        const Eigen::Vector2d at = from + (to - from) * k / steps;
        mask.at(static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))) = 255;
    }
}

}   // namespace

Mask2d bridgeGaps(const Mask2d& mask, const ImageF& ridges, double reachPx, double minRidge)
{
    Mask2d bridged = mask;
    Image2d<int> labels;
    std::vector<FreeEnd> ends;
    runInParallel([&] { ends = findFreeEnds(buildSkeletonGraph(skeletonize(mask))); },
                  [&] { labels = componentLabels(mask); });
    for (const FreeEnd& end : ends) {
        const std::optional<Eigen::Vector2d> target = targetAhead(end, labels, reachPx);
        if (target && meanAlong(ridges, end.point, *target) >= minRidge) {
            drawLine(bridged, end.point, *target);
        }
    }
    return bridged;
}

}   // namespace angiopose::core
