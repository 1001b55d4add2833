#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"

#include <vector>

namespace angiopose::core {

/// Returns the pose near `start` that projects `pointsInPatient` closest to the corresponding `pixels` (least squares).
RigidTransform fitPoseToCorrespondences(const std::vector<Eigen::Vector3d>& pointsInPatient,
                                        const std::vector<Eigen::Vector2d>& pixels, const ProjectionCamera& camera,
                                        const RigidTransform& start);

}   // namespace angiopose::core
