#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"

#include <optional>
#include <span>

namespace angiopose::core {

/// Returns the least-squares pose of points with known pixels by OpenCV's SQPNP, which needs no initial pose; nullopt
/// if the pairs do not determine a pose.
std::optional<RigidTransform> solveSqpnp(std::span<const Eigen::Vector3d> points,
                                         std::span<const Eigen::Vector2d> pixels, const ProjectionCamera& camera);

}   // namespace angiopose::core
