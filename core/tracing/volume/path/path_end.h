#pragma once

#include "core/support/result.h"
#include "core/tracing/volume/path/path_ground.h"

namespace angiopose::core {

/// Where somebody pointed at a vessel.
struct PathEnd {
    Eigen::Vector3i voxel = Eigen::Vector3i::Zero();   ///< the likeliest of a vessel near there
    VesselLook look;
};

/// Fails for a place outside the scan, or in nothing brighter than what is around it.
Result<PathEnd> pathEnd(const PathGround& ground, const Eigen::Vector3d& placeInPatient);

}   // namespace angiopose::core
