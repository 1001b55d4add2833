#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/vessel_tree.h"
#include "ui/scenes/view_rect.h"

#include <optional>
#include <vector>

namespace angiopose::ui {

struct ProjectedPoint {
    Eigen::Vector2d px;
    Eigen::Vector2d along =
        Eigen::Vector2d::Zero();   ///< where the vessel runs to on the image, unit; 0: along the ray
    double radiusPx = 0.0;   ///< 0 when unknown
    double depthMm = 0.0;   ///< from the source along the central ray
    std::size_t index = 0;   ///< of the tree point

    /// The vessel's edge beside it, to the left (+1) or right (−1); 0: itself.
    Eigen::Vector2d edgePx(double side) const { return px + side * radiusPx * Eigen::Vector2d(-along.y(), along.x()); }
};

/// One branch on the image. Where it passes behind the source it falls into several runs.
struct ProjectedBranch {
    int id = 0;
    std::vector<std::vector<ProjectedPoint>> runs;
};
using ProjectedTree = std::vector<ProjectedBranch>;

/// Where a vessel runs to at each of its points, unit, smoothed over its neighbours: its edges lie at right angles to
/// it.
std::vector<Eigen::Vector3d> vesselDirections(const std::vector<Eigen::Vector3d>& points);

ProjectedTree projectedTree(const core::VesselTree& tree, const core::ProjectionCamera& camera,
                            const core::RigidTransform& cameraFromPatient);

/// The branch nearest to an image point, if it is within `tolerancePx`.
std::optional<int> nearestBranch(const ProjectedTree& tree, const Eigen::Vector2d& imagePoint, double tolerancePx);

/// The box around a branch, in image px.
std::optional<ViewRect> extentOf(const ProjectedTree& tree, int branchId);

bool passesThrough(const ProjectedTree& tree, const ViewRect& part);

}   // namespace angiopose::ui