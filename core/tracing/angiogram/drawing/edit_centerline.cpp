#include "core/tracing/angiogram/drawing/edit_centerline.h"

#include "core/tracing/angiogram/curves/curve_refinement.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace angiopose::core {
namespace {

using PointFilter = std::function<bool(const Eigen::Vector2d&)>;

int nextFreeId(const Centerline2d& centerline)
{
    int id = 1;
    for (const Curve2d& curve : centerline.curves) {
        id = std::max(id, curve.id + 1);
    }
    return id;
}

/// Returns the points from `first` up to but not including `end` as a separate curve.
Curve2d sectionOf(const Curve2d& curve, std::size_t first, std::size_t end)
{
    const auto slice = [&](const auto& values) {
        using Values = std::decay_t<decltype(values)>;
        return values.size() == curve.pointsPx.size() ? Values(values.begin() + static_cast<std::ptrdiff_t>(first),
                                                               values.begin() + static_cast<std::ptrdiff_t>(end))
                                                      : Values{};
    };
    return {curve.id, slice(curve.pointsPx), slice(curve.radiusPx)};
}

/// Returns the sections of consecutive points that are kept, each as a curve.
std::vector<Curve2d> splitAtRejectedPoints(const Curve2d& curve, const PointFilter& accepts)
{
    std::vector<Curve2d> parts;
    std::size_t first = 0;
    for (std::size_t i = 0; i <= curve.pointsPx.size(); ++i) {
        if (i < curve.pointsPx.size() && accepts(curve.pointsPx[i])) {
            continue;
        }
        if (i - first >= 2) {
            parts.push_back(sectionOf(curve, first, i));
        }
        first = i + 1;
    }
    return parts;
}

Centerline2d filterPoints(const Centerline2d& centerline, const PointFilter& accepts)
{
    Centerline2d result;
    int nextId = nextFreeId(centerline);
    for (const Curve2d& curve : centerline.curves) {
        std::vector<Curve2d> parts = splitAtRejectedPoints(curve, accepts);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            parts[i].id = i == 0 ? curve.id : nextId++;
            result.curves.push_back(std::move(parts[i]));
        }
    }
    return result;
}

bool isInside(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& point)
{
    bool inside = false;
    for (std::size_t i = 0, last = polygon.size() - 1; i < polygon.size(); last = i++) {
        const Eigen::Vector2d& a = polygon[i];
        const Eigen::Vector2d& b = polygon[last];
        const bool crosses = (a.y() > point.y()) != (b.y() > point.y());
        if (crosses && point.x() < a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y())) {
            inside = !inside;
        }
    }
    return inside;
}

struct CurvePosition {
    std::size_t curve = 0;
    std::size_t point = 0;
};

std::optional<CurvePosition> findNearestPoint(const Centerline2d& centerline, const Eigen::Vector2d& pointPx,
                                              double reachPx)
{
    std::optional<CurvePosition> nearest;
    double nearestPx = reachPx;
    for (std::size_t c = 0; c < centerline.curves.size(); ++c) {
        for (std::size_t i = 0; i < centerline.curves[c].pointsPx.size(); ++i) {
            const double distance = (centerline.curves[c].pointsPx[i] - pointPx).norm();
            if (distance <= nearestPx) {
                nearestPx = distance;
                nearest = CurvePosition{c, i};
            }
        }
    }
    return nearest;
}

}   // namespace

Centerline2d eraseDisc(const Centerline2d& centerline, const Eigen::Vector2d& centerPx, double radiusPx)
{
    return filterPoints(centerline, [&](const Eigen::Vector2d& point) { return (point - centerPx).norm() > radiusPx; });
}

Centerline2d cropToPolygon(const Centerline2d& centerline, const std::vector<Eigen::Vector2d>& polygonPx)
{
    if (polygonPx.size() < 3) {
        return centerline;
    }
    return filterPoints(centerline, [&](const Eigen::Vector2d& point) { return isInside(polygonPx, point); });
}

Centerline2d erasePolygon(const Centerline2d& centerline, const std::vector<Eigen::Vector2d>& polygonPx)
{
    if (polygonPx.size() < 3) {
        return centerline;
    }
    return filterPoints(centerline, [&](const Eigen::Vector2d& point) { return !isInside(polygonPx, point); });
}

Centerline2d splitAt(const Centerline2d& centerline, const Eigen::Vector2d& pointPx, double reachPx)
{
    const std::optional<CurvePosition> position = findNearestPoint(centerline, pointPx, reachPx);
    if (!position) {
        return centerline;
    }
    const Curve2d& curve = centerline.curves[position->curve];
    if (position->point < 1 || position->point + 2 > curve.pointsPx.size() - 1) {
        return centerline;
    }
    Centerline2d result = centerline;
    result.curves[position->curve] = sectionOf(curve, 0, position->point + 1);
    Curve2d secondPart = sectionOf(curve, position->point + 1, curve.pointsPx.size());
    secondPart.id = nextFreeId(centerline);
    result.curves.push_back(std::move(secondPart));
    return result;
}

Centerline2d removeCurve(const Centerline2d& centerline, int id)
{
    Centerline2d result = centerline;
    std::erase_if(result.curves, [id](const Curve2d& curve) { return curve.id == id; });
    return result;
}

Centerline2d addDrawnCurve(const Centerline2d& centerline, const std::vector<Eigen::Vector2d>& pathPx,
                           const ImageF& opacity, double maxRadiusPx)
{
    Centerline2d result = centerline;
    if (pathPx.size() >= 2) {
        const int id = nextFreeId(centerline);
        result.curves.push_back(opacity.isEmpty() ? smoothCurve(pathPx, id)
                                                  : centerCurve(pathPx, id, opacity, maxRadiusPx));
    }
    return result;
}

int curveAt(const Centerline2d& centerline, const Eigen::Vector2d& pointPx, double reachPx)
{
    const std::optional<CurvePosition> position = findNearestPoint(centerline, pointPx, reachPx);
    return position ? centerline.curves[position->curve].id : -1;
}

}   // namespace angiopose::core
