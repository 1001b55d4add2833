#include "ui/scenes/projected_tree.h"

#include "core/vessel/polyline.h"

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

double distanceToSegment(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    const Eigen::Vector2d step = b - a;
    const double length2 = step.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp(step.dot(point - a) / length2, 0.0, 1.0) : 0.0;
    return (point - a - t * step).norm();
}

double distanceToRun(const Eigen::Vector2d& point, const std::vector<ProjectedPoint>& run)
{
    double nearest = (run.front().px - point).norm();
    for (std::size_t i = 1; i < run.size(); ++i) {
        nearest = std::min(nearest, distanceToSegment(point, run[i - 1].px, run[i].px));
    }
    return nearest;
}

Eigen::Vector2d directionOnImage(const core::ProjectionCamera& camera, const Eigen::Vector3d& pointInCamera,
                                 const Eigen::Vector3d& directionInCamera)
{
    const Eigen::Vector2d onImage = core::projectionJacobian(camera, pointInCamera) * directionInCamera;
    return onImage.norm() > 1e-9 ? Eigen::Vector2d(onImage.normalized()) : Eigen::Vector2d(Eigen::Vector2d::Zero());
}

}   // namespace

std::vector<Eigen::Vector3d> vesselDirections(const std::vector<Eigen::Vector3d>& points)
{
    constexpr std::size_t reach = 3;
    return core::polylineTangents<3>(points, reach);
}

ProjectedTree projectTree(const core::VesselTree& tree, const core::ProjectionCamera& camera,
                          const core::RigidTransform& cameraFromPatient)
{
    ProjectedTree result;
    result.reserve(tree.branches.size());
    for (const core::VesselBranch& branch : tree.branches) {
        ProjectedBranch projected{branch.id, {}};
        const std::vector<Eigen::Vector3d> tangents = vesselDirections(branch.pointsInPatient);
        bool isOpen = false;
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            const Eigen::Vector3d pointInCamera = cameraFromPatient * branch.pointsInPatient[i];
            const auto pixel = core::project(camera, pointInCamera);
            if (!pixel || !pixel->allFinite()) {
                isOpen = false;
                continue;
            }
            if (!isOpen) {
                projected.runs.emplace_back();
                isOpen = true;
            }
            const double radiusMm = branch.radiusMm.empty() ? 0.0 : branch.radiusMm[i];
            projected.runs.back().push_back(
                {*pixel, directionOnImage(camera, pointInCamera, cameraFromPatient.rotation * tangents[i]),
                 radiusMm * std::abs(camera.fx) / pointInCamera.z(), pointInCamera.z(), i});
        }
        result.push_back(std::move(projected));
    }
    return result;
}

std::optional<int> nearestBranch(const ProjectedTree& tree, const Eigen::Vector2d& imagePoint, double tolerancePx)
{
    std::optional<int> nearest;
    double distance = tolerancePx;
    for (const ProjectedBranch& branch : tree) {
        for (const auto& run : branch.runs) {
            const double candidate = distanceToRun(imagePoint, run);
            if (candidate <= distance) {
                distance = candidate;
                nearest = branch.id;
            }
        }
    }
    return nearest;
}

std::optional<ViewRect> extentOf(const ProjectedTree& tree, int branchId)
{
    std::optional<ViewRect> box;
    for (const ProjectedBranch& branch : tree) {
        if (branch.id != branchId) {
            continue;
        }
        for (const auto& run : branch.runs) {
            for (const ProjectedPoint& point : run) {
                const double u = point.px.x();
                const double v = point.px.y();
                box = box ? ViewRect{std::min(box->left, u), std::max(box->right, u), std::min(box->top, v),
                                     std::max(box->bottom, v)}
                          : ViewRect{u, u, v, v};
            }
        }
    }
    return box;
}

bool intersectsRect(const ProjectedTree& tree, const ViewRect& part)
{
    const auto isInside = [&part](const ProjectedPoint& point) {
        return point.px.x() >= part.left && point.px.x() <= part.right && point.px.y() >= part.top &&
               point.px.y() <= part.bottom;
    };
    return std::any_of(tree.begin(), tree.end(), [&](const ProjectedBranch& branch) {
        return std::any_of(branch.runs.begin(), branch.runs.end(),
                           [&](const auto& run) { return std::any_of(run.begin(), run.end(), isInside); });
    });
}

}   // namespace angiopose::ui
