#include "core/vessel/tree_position.h"

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
struct NearestPosition {
    double distance = std::numeric_limits<double>::infinity();
    TreePosition position;

    void update(double distanceOfOther, const TreePosition& other)
    {
        if (distanceOfOther < distance) {
            distance = distanceOfOther;
            position = other;
        }
    }
};

constexpr double chordMm = 3.0;

/// Returns the branch point at arc length `arcLengthMm` from a position (negative: backward), or the end of the branch.
Eigen::Vector3d advanceAlong(const VesselTree& tree, TreePosition position, double arcLengthMm)
{
    const std::vector<Eigen::Vector3d>& points = tree.branches[position.branch].pointsInPatient;
    Eigen::Vector3d at = pointAt(tree, position);
    const bool isForward = arcLengthMm > 0.0;
    for (double remainingMm = std::abs(arcLengthMm); remainingMm > 0.0;) {
        const Eigen::Vector3d& next = points[isForward ? position.segment + 1 : position.segment];
        const double stepMm = (next - at).norm();
        if (stepMm >= remainingMm) {
            return at + remainingMm / stepMm * (next - at);
        }
        remainingMm -= stepMm;
        at = next;
        if (isForward ? position.segment + 2 >= points.size() : position.segment == 0) {
            break;
        }
        position.segment += isForward ? 1 : std::size_t(-1);
    }
    return at;
}

}   // namespace

std::optional<TreePosition> nearestPosition(const VesselTree& tree, const Eigen::Vector3d& pointInPatient)
{
    NearestPosition nearest;
    for (std::size_t b = 0; b < tree.branches.size(); ++b) {
        const auto& points = tree.branches[b].pointsInPatient;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double t = fractionNearest(points[i - 1], points[i], pointInPatient);
            const Eigen::Vector3d position = points[i - 1] + t * (points[i] - points[i - 1]);
            nearest.update((position - pointInPatient).norm(), {b, i - 1, t});
        }
    }
    return std::isfinite(nearest.distance) ? std::optional(nearest.position) : std::nullopt;
}

Eigen::Vector3d pointAt(const VesselTree& tree, const TreePosition& position)
{
    const std::vector<Eigen::Vector3d>& points = tree.branches[position.branch].pointsInPatient;
    const Eigen::Vector3d& from = points[position.segment];
    return from + position.fraction * (points[position.segment + 1] - from);
}

Eigen::Vector3d directionAt(const VesselTree& tree, const TreePosition& position)
{
    const Eigen::Vector3d chord =
        advanceAlong(tree, position, 0.5 * chordMm) - advanceAlong(tree, position, -0.5 * chordMm);
    return chord.norm() > 0.0 ? chord.normalized() : Eigen::Vector3d::UnitZ();
}

std::optional<double> radiusAt(const VesselTree& tree, const TreePosition& position)
{
    const VesselBranch& branch = tree.branches[position.branch];
    if (branch.radiusMm.size() != branch.pointsInPatient.size()) {
        return std::nullopt;
    }
    const double from = branch.radiusMm[position.segment];
    const double radius = from + position.fraction * (branch.radiusMm[position.segment + 1] - from);
    return std::isfinite(radius) && radius > 0.0 ? std::optional(radius) : std::nullopt;
}

std::optional<Eigen::Vector3d> nearestPointOnTree(const VesselTree& tree, const Eigen::Vector3d& pointInPatient)
{
    const auto position = nearestPosition(tree, pointInPatient);
    return position ? std::optional(pointAt(tree, *position)) : std::nullopt;
}

std::optional<Eigen::Vector3d> pointUnderPixel(const VesselTree& tree, const PosedCamera& posedCamera,
                                               const Eigen::Vector2d& pixel, double reachPx)
{
    NearestPosition nearest;
    for (std::size_t b = 0; b < tree.branches.size(); ++b) {
        const auto& points = tree.branches[b].pointsInPatient;
        std::optional<Eigen::Vector2d> previous;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto projected = project(posedCamera.camera, posedCamera.cameraFromPatient * points[i]);
            if (projected && previous) {
                const double t = fractionNearest(*previous, *projected, pixel);
                nearest.update((*previous + t * (*projected - *previous) - pixel).norm(), {b, i - 1, t});
            }
            previous = projected;
        }
    }
    return nearest.distance <= reachPx ? std::optional(pointAt(tree, nearest.position)) : std::nullopt;
}

}   // namespace angiopose::core
