#pragma once

#include "core/support/result.h"
#include "core/tracing/volume/path/path_ground.h"

namespace angiopose::core {

/// End of a path, where the user pointed at a vessel.
struct PathEnd {
    Eigen::Vector3i voxel = Eigen::Vector3i::Zero();   ///< most likely vessel voxel nearby
    VesselLook look;
};

/// Finds the vessel voxel for a point. Fails if the point lies outside the scan or in nothing brighter than its
/// surroundings.
Result<PathEnd> pathEnd(const PathGround& ground, const Eigen::Vector3d& placeInPatient);

}   // namespace angiopose::core
