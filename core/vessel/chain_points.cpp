#include "core/vessel/chain_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace angiopose::core {
namespace {

constexpr double reachInSpacings = 2.5;
constexpr double besideOnGridPx = 1.5;   // distance up to which grid pixels are adjacent, slightly more than √2

struct Joint {
    double lengthPx = 0.0;
    std::size_t first = 0;
    std::size_t second = 0;

    bool operator<(const Joint& other) const
    {
        return std::tie(lengthPx, first, second) < std::tie(other.lengthPx, other.first, other.second);
    }
};

using ImagePoints = std::vector<Eigen::Vector2d>;
using JoinedPoints = std::vector<std::vector<std::size_t>>;

std::vector<std::size_t> fromLeftToRight(const ImagePoints& points)
{
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        return std::tuple(points[a].x(), points[a].y(), a) < std::tuple(points[b].x(), points[b].y(), b);
    });
    return order;
}

/// Returns every pair of points closer than `reachPx`; `order` sorts the points from left to right.
std::vector<Joint> jointsWithin(const ImagePoints& points, const std::vector<std::size_t>& order, double reachPx)
{
    std::vector<Joint> joints;
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t k = i + 1; k < order.size(); ++k) {
            const Eigen::Vector2d apart = points[order[k]] - points[order[i]];
            if (apart.x() > reachPx) {
                break;
            }
            if (apart.norm() <= reachPx) {
                joints.push_back({apart.norm(), std::min(order[i], order[k]), std::max(order[i], order[k])});
            }
        }
    }
    return joints;
}

/// Returns the distance from the point at `place` of `order` to its nearest neighbor; infinite if there is none.
double distanceToNearest(const ImagePoints& points, const std::vector<std::size_t>& order, std::size_t place)
{
    double nearest = std::numeric_limits<double>::infinity();
    const Eigen::Vector2d& point = points[order[place]];
    const auto isFurther = [&](std::size_t other) {   // if true, all points beyond this one are farther away, too
        const Eigen::Vector2d apart = points[order[other]] - point;
        nearest = std::min(nearest, apart.norm());
        return std::abs(apart.x()) > nearest;
    };
    for (std::size_t right = place + 1; right < order.size() && !isFurther(right); ++right) {
    }
    for (std::size_t left = place; left > 0 && !isFurther(left - 1); --left) {
    }
    return nearest;
}

/// Returns the median distance of the points to their nearest neighbors.
double usualSpacing(const ImagePoints& points, const std::vector<std::size_t>& order)
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
JoinedPoints spanningForest(std::size_t count, std::vector<Joint> joints)
{
    std::ranges::sort(joints, std::less{});
    std::vector<std::size_t> parents(count);
    std::iota(parents.begin(), parents.end(), std::size_t{0});
    JoinedPoints neighbors(count);
    for (const Joint& joint : joints) {
        const std::size_t first = rootOf(parents, joint.first);
        const std::size_t second = rootOf(parents, joint.second);
        if (first != second) {
            parents[first] = second;
            neighbors[joint.first].push_back(joint.second);
            neighbors[joint.second].push_back(joint.first);
        }
    }
    return neighbors;
}

/// Follows unused points from `start` to the next end or bifurcation.
Curve2d curveFrom(std::size_t start, const ImagePoints& points, const JoinedPoints& neighbors,
                  std::vector<char>& isTaken)
{
    Curve2d curve;
    for (std::size_t at = start;;) {
        isTaken[at] = 1;
        curve.pointsPx.push_back(points[at]);
        const auto next = std::ranges::find_if(neighbors[at], [&](std::size_t point) { return !isTaken[point]; });
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
    const std::vector<std::size_t> order = fromLeftToRight(points);
    const double reachPx = std::max(besideOnGridPx, reachInSpacings * usualSpacing(points, order));
    const JoinedPoints neighbors = spanningForest(points.size(), jointsWithin(points, order, reachPx));
    std::vector<char> isTaken(points.size());
    const auto collect = [&](const auto& isStart) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!isTaken[i] && isStart(i)) {
                centerline.curves.push_back(curveFrom(i, points, neighbors, isTaken));
                centerline.curves.back().id = static_cast<int>(centerline.curves.size());
            }
        }
    };
    collect([&](std::size_t i) { return neighbors[i].size() < 2; });   // curves that start at an end
    collect([&](std::size_t i) { return neighbors[i].size() > 2; });   // start at bifurcations that no end led to
    const auto isCutOff = [&](std::size_t point) { return isTaken[point] != 0; };
    collect([&](std::size_t i) { return std::ranges::any_of(neighbors[i], isCutOff); });   // start between bifurcations
    collect([](std::size_t) { return true; });
    return centerline;
}

}   // namespace angiopose::core
