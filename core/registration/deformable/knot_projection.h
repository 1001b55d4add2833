#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/registration/deformable/curve_crossings.h"
#include "core/vessel/tree_knots.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace angiopose::core {

/// Projection of one knot in one view, with the derivatives of its position across the vessel.
struct KnotProjection {
    std::size_t knot = 0;
    Eigen::Vector2d positionPx;
    Eigen::Vector2d normal;   ///< unit vector across the projected vessel
    double mmPerPx = 0.0;   ///< at the depth of the knot
    double visibleMm = 0.0;   ///< vessel length that the knot represents, measured across the ray
    Eigen::Vector3d motionJacobian;   ///< mm across the vessel per mm of motion, patient axes
    Vector6d poseJacobian;   ///< mm across the vessel per step (rad, mm) of the first view's pose about the centroid
    Vector6d geometryJacobian;   ///< mm across the vessel per correction of this view's geometry
};

/// Current state of the deformed tree.
struct DeformedTree {
    RigidTransform cameraFromPatient;   ///< pose in the first view
    Eigen::Matrix3Xd motionMm;   ///< motion of each knot, patient axes
};

/// View data needed by the fit of a deformed tree.
struct ProjectionContext {
    ProjectionCamera camera;
    RigidTransform cameraFromFirst;   ///< includes the geometry correction
    Eigen::Vector3d centroidInPatient = Eigen::Vector3d::Zero();
    const CurveCrossings* curves = nullptr;
};

/// Returns one projection per knot; nullopt on an excluded branch, behind the source, or on a vessel along the ray.
std::vector<std::optional<KnotProjection>> projectKnots(const TreeKnots& knots, const DeformedTree& deformed,
                                                        const ProjectionContext& context);

}   // namespace angiopose::core
