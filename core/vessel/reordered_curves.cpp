#include "core/vessel/reordered_curves.h"

#include "core/vessel/chain_points.h"

#include <algorithm>
#include <limits>

namespace angiopose::core {
namespace {

constexpr std::size_t minCheckedPoints = 8;   // minimum number of points for checking the order of a curve
constexpr std::size_t maxSampledPoints = 48;
constexpr std::size_t firstSampledPoints = 16;   // if all but one of these are in order, the curve counts as ordered
constexpr double minInOrder = 0.8;   // nearly 1 for curves, 0.4 to 0.7 for pixels listed row by row
constexpr double nearlyNearest = 1.5;   // maximum ratio to the nearest distance; steps along the pixel grid are 1 or √2
constexpr std::size_t minLonePoints = 20;

bool isInOrder(const std::vector<Eigen::Vector2d>& points, std::size_t i)
{
    double nearest = std::numeric_limits<double>::infinity();
    double adjacent = std::numeric_limits<double>::infinity();
    for (std::size_t other = 0; other < points.size(); ++other) {
        const double squared = (points[other] - points[i]).squaredNorm();
        if (other + 1 == i || other == i + 1) {
            adjacent = std::min(adjacent, squared);
        }
        // Ignores duplicates of the point.
        if (other != i && squared > 0.0) {
            nearest = std::min(nearest, squared);
        }
    }
    return adjacent <= nearlyNearest * nearlyNearest * nearest;
}

/// Returns how many of a number of points, evenly distributed over the curve, are in order.
std::size_t countInOrder(const std::vector<Eigen::Vector2d>& points, std::size_t sampleCount)
{
    std::size_t inOrder = 0;
    for (std::size_t k = 0; k < sampleCount; ++k) {
        inOrder += isInOrder(points, k * points.size() / sampleCount) ? 1 : 0;
    }
    return inOrder;
}

bool isUnordered(const Curve2d& curve)
{
    const std::size_t count = curve.pointsPx.size();
    if (count < minCheckedPoints) {
        return false;
    }
    if (count >= maxSampledPoints && countInOrder(curve.pointsPx, firstSampledPoints) + 1 >= firstSampledPoints) {
        return false;
    }
    const std::size_t sampleCount = std::min(count, maxSampledPoints);
    return static_cast<double>(countInOrder(curve.pointsPx, sampleCount)) <
           minInOrder * static_cast<double>(sampleCount);
}

/// Returns whether most curves are single points.
bool hasMostlySinglePoints(const Centerline2d& input)
{
    const auto single = static_cast<std::size_t>(
        std::ranges::count_if(input.curves, [](const Curve2d& curve) { return curve.pointsPx.size() == 1; }));
    return single >= minLonePoints && 2 * single > input.curves.size();
}

}   // namespace

std::optional<ReorderedCurves> reorderCurves(const Centerline2d& input)
{
    const bool shouldChainSingles = hasMostlySinglePoints(input);
    const auto isUnorderedOrSingle = [&](const Curve2d& curve) {
        return (shouldChainSingles && curve.pointsPx.size() == 1) || isUnordered(curve);
    };
    ReorderedCurves result;
    std::vector<Eigen::Vector2d> unordered;
    std::vector<const Curve2d*> inOrder;
    int lastId = 0;
    for (const Curve2d& curve : input.curves) {
        lastId = std::max(lastId, curve.id);
        if (isUnorderedOrSingle(curve)) {
            unordered.insert(unordered.end(), curve.pointsPx.begin(), curve.pointsPx.end());
        } else {
            inOrder.push_back(&curve);
        }
    }
    if (unordered.empty()) {
        return {};
    }
    result.reorderedPoints = unordered.size();
    for (const Curve2d* curve : inOrder) {
        result.curves.curves.push_back(*curve);
    }
    for (Curve2d& curve : chainPoints(unordered).curves) {
        curve.id = ++lastId;
        result.curves.curves.push_back(std::move(curve));
    }
    return result;
}

}   // namespace angiopose::core
