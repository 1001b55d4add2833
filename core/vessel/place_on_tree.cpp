#include "core/vessel/place_on_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

/// 0 … 1 from a to b: where the segment comes nearest to a point.
template <class Vector>
double fractionNearest(const Vector& a, const Vector& b, const Vector& point)
{
    const double length2 = (b - a).squaredNorm();
    return length2 > 0.0 ? std::clamp((point - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
}

/// The nearest place so far.
struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();

    void offer(double distanceOfOther, const Eigen::Vector3d& other)
    {
        if (distanceOfOther < distance) {
            distance = distanceOfOther;
            pointInPatient = other;
        }
    }
};

}   // namespace

std::optional<Eigen::Vector3d> nearestOnTree(const VesselTree& tree, const Eigen::Vector3d& pointInPatient)
{
    Nearest nearest;
    for (const VesselBranch& branch : tree.branches) {
        const auto& points = branch.pointsInPatient;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double t = fractionNearest(points[i - 1], points[i], pointInPatient);
            const Eigen::Vector3d place = points[i - 1] + t * (points[i] - points[i - 1]);
            nearest.offer((place - pointInPatient).norm(), place);
        }
    }
    return std::isfinite(nearest.distance) ? std::optional(nearest.pointInPatient) : std::nullopt;
}

std::optional<Eigen::Vector3d> placeUnderPixel(const VesselTree& tree, const Sight& sight, const Eigen::Vector2d& pixel,
                                               double reachPx)
{
    Nearest nearest;
    for (const VesselBranch& branch : tree.branches) {
        std::optional<Eigen::Vector2d> before;
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            const Eigen::Vector3d& point = branch.pointsInPatient[i];
            const auto seen = project(sight.camera, sight.cameraFromPatient * point);
            if (seen && before) {
                const double t = fractionNearest(*before, *seen, pixel);
                const Eigen::Vector3d& last = branch.pointsInPatient[i - 1];
                nearest.offer((*before + t * (*seen - *before) - pixel).norm(), last + t * (point - last));
            }
            before = seen;
        }
    }
    return nearest.distance <= reachPx ? std::optional(nearest.pointInPatient) : std::nullopt;
}

}   // namespace angiopose::core