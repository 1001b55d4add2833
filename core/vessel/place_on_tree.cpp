#include "core/vessel/place_on_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

/// Returns the position on the segment a–b nearest to a point, from 0 at a to 1 at b.
template <class Vector>
double fractionNearest(const Vector& a, const Vector& b, const Vector& point)
{
    const double length2 = (b - a).squaredNorm();
    return length2 > 0.0 ? std::clamp((point - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
}

/// The nearest position found so far.
struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    TreePlace place;

    void offer(double distanceOfOther, const TreePlace& other)
    {
        if (distanceOfOther < distance) {
            distance = distanceOfOther;
            place = other;
        }
    }
};

constexpr double chordMm = 3.0;

/// Returns the branch point at arc length `wayMm` from a position (negative: backward), or the end of the branch.
Eigen::Vector3d pointFurther(const VesselTree& tree, TreePlace place, double wayMm)
{
    const std::vector<Eigen::Vector3d>& points = tree.branches[place.branch].pointsInPatient;
    Eigen::Vector3d at = pointAt(tree, place);
    const bool isForward = wayMm > 0.0;
    for (double leftMm = std::abs(wayMm); leftMm > 0.0;) {
        const Eigen::Vector3d& next = points[isForward ? place.segment + 1 : place.segment];
        const double stepMm = (next - at).norm();
        if (stepMm >= leftMm) {
            return at + leftMm / stepMm * (next - at);
        }
        leftMm -= stepMm;
        at = next;
        if (isForward ? place.segment + 2 >= points.size() : place.segment == 0) {
            break;
        }
        place.segment += isForward ? 1 : std::size_t(-1);
    }
    return at;
}

}   // namespace

std::optional<TreePlace> nearestPlace(const VesselTree& tree, const Eigen::Vector3d& pointInPatient)
{
    Nearest nearest;
    for (std::size_t b = 0; b < tree.branches.size(); ++b) {
        const auto& points = tree.branches[b].pointsInPatient;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double t = fractionNearest(points[i - 1], points[i], pointInPatient);
            const Eigen::Vector3d place = points[i - 1] + t * (points[i] - points[i - 1]);
            nearest.offer((place - pointInPatient).norm(), {b, i - 1, t});
        }
    }
    return std::isfinite(nearest.distance) ? std::optional(nearest.place) : std::nullopt;
}

Eigen::Vector3d pointAt(const VesselTree& tree, const TreePlace& place)
{
    const std::vector<Eigen::Vector3d>& points = tree.branches[place.branch].pointsInPatient;
    const Eigen::Vector3d& from = points[place.segment];
    return from + place.fraction * (points[place.segment + 1] - from);
}

Eigen::Vector3d directionAt(const VesselTree& tree, const TreePlace& place)
{
    const Eigen::Vector3d chord = pointFurther(tree, place, 0.5 * chordMm) - pointFurther(tree, place, -0.5 * chordMm);
    return chord.norm() > 0.0 ? chord.normalized() : Eigen::Vector3d::UnitZ();
}

std::optional<double> radiusAt(const VesselTree& tree, const TreePlace& place)
{
    const VesselBranch& branch = tree.branches[place.branch];
    if (branch.radiusMm.size() != branch.pointsInPatient.size()) {
        return std::nullopt;
    }
    const double from = branch.radiusMm[place.segment];
    const double radius = from + place.fraction * (branch.radiusMm[place.segment + 1] - from);
    return std::isfinite(radius) && radius > 0.0 ? std::optional(radius) : std::nullopt;
}

std::optional<Eigen::Vector3d> nearestOnTree(const VesselTree& tree, const Eigen::Vector3d& pointInPatient)
{
    const auto place = nearestPlace(tree, pointInPatient);
    return place ? std::optional(pointAt(tree, *place)) : std::nullopt;
}

std::optional<Eigen::Vector3d> placeUnderPixel(const VesselTree& tree, const Sight& sight, const Eigen::Vector2d& pixel,
                                               double reachPx)
{
    Nearest nearest;
    for (std::size_t b = 0; b < tree.branches.size(); ++b) {
        const auto& points = tree.branches[b].pointsInPatient;
        std::optional<Eigen::Vector2d> before;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto seen = project(sight.camera, sight.cameraFromPatient * points[i]);
            if (seen && before) {
                const double t = fractionNearest(*before, *seen, pixel);
                nearest.offer((*before + t * (*seen - *before) - pixel).norm(), {b, i - 1, t});
            }
            before = seen;
        }
    }
    return nearest.distance <= reachPx ? std::optional(pointAt(tree, nearest.place)) : std::nullopt;
}

}   // namespace angiopose::core
