#include "core/vessel/vessel_mark.h"

#include "core/vessel/tree_position.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

bool haveSamePoints(const VesselTree& one, const VesselTree& other)
{
    return std::ranges::equal(one.branches, other.branches, [](const VesselBranch& a, const VesselBranch& b) {
        return a.id == b.id && a.pointsInPatient.size() == b.pointsInPatient.size();
    });
}

}   // namespace

int nextMarkId(const std::vector<VesselMark>& marks)
{
    int next = 1;
    for (const VesselMark& mark : marks) {
        next = std::max(next, mark.id + 1);
    }
    return next;
}

std::vector<Eigen::Vector3d> ringPoints(const VesselMark& ring, std::size_t count)
{
    const Eigen::Vector3d one = ring.normal.unitOrthogonal();
    const Eigen::Vector3d other = ring.normal.cross(one);
    std::vector<Eigen::Vector3d> points(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
        points[i] = ring.pointInPatient + ring.radiusMm * (std::cos(angle) * one + std::sin(angle) * other);
    }
    return points;
}

VesselMark moveWithVessels(const VesselTree& from, const VesselTree& to, VesselMark mark)
{
    const auto place = haveSamePoints(from, to) ? nearestPosition(from, mark.pointInPatient) : std::nullopt;
    if (place) {
        mark.pointInPatient += pointAt(to, *place) - pointAt(from, *place);
        mark.normal =
            Eigen::Quaterniond::FromTwoVectors(directionAt(from, *place), directionAt(to, *place)) * mark.normal;
    }
    return mark;
}

}   // namespace angiopose::core
