#include "core/vessel/chain_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace angiopose::core {
namespace {

constexpr double reachInSpacings = 2.5;
constexpr double maxGridNeighborPx = 1.5;   // distance up to which grid pixels are adjacent, slightly more than √2

struct PointLink {
    double lengthPx = 0.0;
    std::size_t first = 0;
    std::size_t second = 0;

    bool operator<(const PointLink& other) const
    {
        return std::tie(lengthPx, first, second) < std::tie(other.lengthPx, other.first, other.second);
    }
};

using ImagePoints = std::vector<Eigen::Vector2d>;
using NeighborLists = std::vector<std::vector<std::size_t>>;

std::vector<std::size_t> sortLeftToRight(const ImagePoints& points)
{
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        return std::tuple(points[a].x(), points[a].y(), a) < std::tuple(points[b].x(), points[b].y(), b);
    });
    return order;
}

/// Returns every pair of points closer than `reachPx`; `order` sorts the points from left to right.
std::vector<PointLink> findLinksWithin(const ImagePoints& points, const std::vector<std::size_t>& order, double reachPx)
{
    std::vector<PointLink> links;
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t k = i + 1; k < order.size(); ++k) {
            const Eigen::Vector2d offset = points[order[k]] - points[order[i]];
            if (offset.x() > reachPx) {
                break;
            }
            if (offset.norm() <= reachPx) {
                links.push_back({offset.norm(), std::min(order[i], order[k]), std::max(order[i], order[k])});
            }
        }
    }
    return links;
}

/// Returns the distance from the point at `place` of `order` to its nearest neighbor; infinite if there is none.
double distanceToNearest(const ImagePoints& points, const std::vector<std::size_t>& order, std::size_t place)
{
    double nearest = std::numeric_limits<double>::infinity();
    const Eigen::Vector2d& point = points[order[place]];
    const auto isTooFar = [&](std::size_t other) {   // if true, all points beyond this one are farther away, too
        const Eigen::Vector2d offset = points[order[other]] - point;
        nearest = std::min(nearest, offset.norm());
        return std::abs(offset.x()) > nearest;
    };
    for (std::size_t right = place + 1; right < order.size() && !isTooFar(right); ++right) {
    }
    for (std::size_t left = place; left > 0 && !isTooFar(left - 1); --left) {
    }
    return nearest;
}

/// Returns the median distance of the points to their nearest neighbors.
double typicalSpacing(const ImagePoints& points, const std::vector<std::size_t>& order)
{
    std::vector<double> nearest(order.size());
    for (std::size_t place = 0; place < order.size(); ++place) {
        nearest[place] = distanceToNearest(points, order, place);
    }
    const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
    std::nth_element(nearest.begin(), middle, nearest.end());
    return *middle;
}

std::size_t rootOf(std::vector<std::size_t>& parents, std::size_t point)
{
    while (parents[point] != point) {
        parents[point] = parents[parents[point]];
        point = parents[point];
    }
    return point;
}

/// Returns the neighbors of each point in the minimum spanning forest (Kruskal).
NeighborLists spanningForest(std::size_t count, std::vector<PointLink> links)
{
    std::ranges::sort(links, std::less{});
    std::vector<std::size_t> parents(count);
    std::iota(parents.begin(), parents.end(), std::size_t{0});
    NeighborLists neighbors(count);
    for (const PointLink& link : links) {
        const std::size_t first = rootOf(parents, link.first);
        const std::size_t second = rootOf(parents, link.second);
        if (first != second) {
            parents[first] = second;
            neighbors[link.first].push_back(link.second);
            neighbors[link.second].push_back(link.first);
        }
    }
    return neighbors;
}

/// Follows unused points from `start` to the next end or bifurcation.
Curve2d curveFrom(std::size_t start, const ImagePoints& points, const NeighborLists& neighbors,
                  std::vector<char>& isUsed)
{
    Curve2d curve;
    for (std::size_t at = start;;) {
        isUsed[at] = 1;
        curve.pointsPx.push_back(points[at]);
        const auto next = std::ranges::find_if(neighbors[at], [&](std::size_t point) { return !isUsed[point]; });
        if (next == neighbors[at].end() || (neighbors[at].size() > 2 && at != start)) {
            return curve;
        }
        at = *next;
    }
}

}   // namespace

Centerline2d chainPoints(const ImagePoints& points)
{
    Centerline2d centerline;
    if (points.empty()) {
        return centerline;
    }
    const std::vector<std::size_t> order = sortLeftToRight(points);
    const double reachPx = std::max(maxGridNeighborPx, reachInSpacings * typicalSpacing(points, order));
    const NeighborLists neighbors = spanningForest(points.size(), findLinksWithin(points, order, reachPx));
    std::vector<char> isUsed(points.size());
    const auto collect = [&](const auto& isStart) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!isUsed[i] && isStart(i)) {
                centerline.curves.push_back(curveFrom(i, points, neighbors, isUsed));
                centerline.curves.back().id = static_cast<int>(centerline.curves.size());
            }
        }
    };
    collect([&](std::size_t i) { return neighbors[i].size() < 2; });   // curves that start at an end
    collect([&](std::size_t i) { return neighbors[i].size() > 2; });   // start at bifurcations that no end led to
    const auto isCutOff = [&](std::size_t point) { return isUsed[point] != 0; };
    collect([&](std::size_t i) { return std::ranges::any_of(neighbors[i], isCutOff); });   // start between bifurcations
    collect([](std::size_t) { return true; });
    return centerline;
}

}   // namespace angiopose::core
