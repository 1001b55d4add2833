#pragma once

#include "core/support/result.h"
#include "core/tracing/volume/path/tube_detector.h"

namespace angiopose::core {

/// End of a path, at a point that the user picked on a vessel.
struct PathEnd {
    Eigen::Vector3i voxel = Eigen::Vector3i::Zero();   ///< most likely vessel voxel nearby
    VesselAppearance appearance;
};

/// Finds the vessel voxel for a picked point. Fails if the point lies outside the scan or not in a structure brighter
/// than its surroundings.
Result<PathEnd> findPathEnd(const TubeDetector& detector, const Eigen::Vector3d& positionInPatient);

}   // namespace angiopose::core
