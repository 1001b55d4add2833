#include "core/simulation/extra_vessels.h"

#include "core/simulation/smooth_path.h"
#include "core/vessel/polyline.h"

#include <Eigen/Geometry>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr double catheterRadiusMm = 0.8;
constexpr double catheterLengthMm = 320.0;

Eigen::Vector3d randomNormal(const Eigen::Vector3d& direction, CounterRandom& random)
{
    const double turn = random.uniform(0.0, 2.0 * std::numbers::pi);
    return Eigen::AngleAxisd(turn, direction) * direction.unitOrthogonal();
}

}   // namespace

VesselBranch growSideBranch(const VesselBranch& parent, std::size_t takeoff, CounterRandom& random)
{
    const Eigen::Vector3d tangent = polylineTangents<3>(parent.pointsInPatient, 3)[takeoff];
    const Eigen::Vector3d side = randomNormal(tangent, random);
    PathPlan plan;
    plan.start = parent.pointsInPatient[takeoff];
    plan.startDirection = (tangent + random.uniform(0.6, 1.2) * side).normalized();
    plan.endDirection = (0.4 * tangent + side).normalized();
    plan.end = plan.start + random.uniform(25.0, 70.0) * (0.5 * tangent + side).normalized();
    VesselBranch branch;
    branch.pointsInPatient = smoothPath(plan, random);
    const double inletRadiusMm = 0.6 * parent.radiusMm[takeoff];
    for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
        const double along = static_cast<double>(i) / static_cast<double>(branch.pointsInPatient.size() - 1);
        branch.radiusMm.push_back(inletRadiusMm * (1.0 - 0.4 * along));
    }
    return branch;
}

VesselBranch layCatheter(const VesselBranch& trunk, CounterRandom& random)
{
    const Eigen::Vector3d forward = polylineTangents<3>(trunk.pointsInPatient, 4).front();
    const Eigen::Vector3d side = randomNormal(forward, random);
    PathPlan plan;
    plan.end = trunk.pointsInPatient.front();
    plan.start = plan.end - catheterLengthMm * (forward + random.uniform(0.2, 0.7) * side).normalized();
    plan.startDirection = forward;
    plan.endDirection = forward;
    plan.tortuosity = 0.6;
    VesselBranch catheter;
    catheter.pointsInPatient = smoothPath(plan, random);
    catheter.radiusMm.assign(catheter.pointsInPatient.size(), catheterRadiusMm);
    return catheter;
}

}   // namespace angiopose::core