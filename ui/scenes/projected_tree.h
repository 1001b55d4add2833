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
    Eigen::Vector2d along = Eigen::Vector2d::Zero();   ///< unit direction in the image; zero along the ray
    double radiusPx = 0.0;   ///< radius of the vessel; 0 if unknown
    double depthMm = 0.0;   ///< depth from the source along the central ray
    std::size_t index = 0;   ///< index of the point in its branch

    /// Returns the edge of the vessel to the left (+1) or right (−1) of the point, or the point itself (0).
    Eigen::Vector2d edgePx(double side) const { return px + side * radiusPx * Eigen::Vector2d(-along.y(), along.x()); }
};

/// Projection of one branch, split into runs of points in front of the X-ray source.
struct ProjectedBranch {
    int id = 0;
    std::vector<std::vector<ProjectedPoint>> runs;
};
using ProjectedTree = std::vector<ProjectedBranch>;

/// Returns the unit direction of a vessel at each of its points, smoothed over neighboring points.
std::vector<Eigen::Vector3d> vesselDirections(const std::vector<Eigen::Vector3d>& points);

ProjectedTree projectTree(const core::VesselTree& tree, const core::ProjectionCamera& camera,
                          const core::RigidTransform& cameraFromPatient);

/// Returns the branch nearest to an image point, if within `tolerancePx`.
std::optional<int> nearestBranch(const ProjectedTree& tree, const Eigen::Vector2d& imagePoint, double tolerancePx);

/// Returns the bounding box of a branch, in image px.
std::optional<ViewRect> extentOf(const ProjectedTree& tree, int branchId);

bool intersectsRect(const ProjectedTree& tree, const ViewRect& part);

}   // namespace angiopose::ui
