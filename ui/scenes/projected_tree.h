#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/vessel_tree.h"
#include "ui/scenes/overlay_scene.h"

#include <optional>
#include <vector>

namespace angiopose::ui {

struct ProjectedPoint {
    Eigen::Vector2d px;
    double radiusPx = 0.0;   ///< 0 when unknown
    double depthMm = 0.0;   ///< from the source along the central ray
    std::size_t index = 0;   ///< of the tree point
};

/// One branch on the image. Where it passes behind the source it falls into several runs.
struct ProjectedBranch {
    int id = 0;
    std::vector<std::vector<ProjectedPoint>> runs;
};
using ProjectedTree = std::vector<ProjectedBranch>;

ProjectedTree projectedTree(const core::VesselTree& tree, const core::ProjectionCamera& camera,
                            const core::RigidTransform& cameraFromPatient);

/// The branch nearest to an image point, if it is within `tolerancePx`.
std::optional<int> nearestBranch(const ProjectedTree& tree, const Eigen::Vector2d& imagePoint, double tolerancePx);

/// The box around a branch, in image px.
std::optional<ViewRect> extentOf(const ProjectedTree& tree, int branchId);

bool passesThrough(const ProjectedTree& tree, const ViewRect& part);

}   // namespace angiopose::ui