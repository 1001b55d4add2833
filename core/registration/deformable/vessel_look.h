#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/registration/deformable/curve_crossings.h"
#include "core/vessel/tree_knots.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace angiopose::core {

/// How one knot looks in one view, and what moves it across its own vessel there.
struct KnotLook {
    std::size_t knot = 0;
    Eigen::Vector2d placePx;
    Eigen::Vector2d normal;   ///< unit, across the projected vessel
    double mmPerPx = 0.0;   ///< at its depth
    double seenMm = 0.0;   ///< length across the ray of what the knot stands for
    Eigen::Vector3d byMotion;   ///< mm across the vessel per mm of motion, patient axes
    Vector6d byPose;   ///< the same per step (rad, mm) of the first view's pose about the centroid
    Vector6d byGeometry;   ///< the same per correction of this view's geometry
};

/// The bent tree as it is for the moment.
struct DeformedTree {
    RigidTransform cameraFromPatient;   ///< of the first view
    Eigen::Matrix3Xd motionMm;   ///< of each knot, patient axes
};

/// One view as the fit of a bent tree needs it.
struct DeformableSight {
    ProjectionCamera camera;
    RigidTransform cameraFromFirst;   ///< corrected
    Eigen::Vector3d centroidInPatient = Eigen::Vector3d::Zero();
    const CurveCrossings* curves = nullptr;
};

/// Nothing for a knot of an excluded branch, behind the source, or whose vessel runs along the ray.
std::vector<std::optional<KnotLook>> lookAt(const TreeKnots& knots, const DeformedTree& deformed,
                                            const DeformableSight& sight);

}   // namespace angiopose::core
