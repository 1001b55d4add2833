#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/support/result.h"

#include <cstdint>
#include <string>

namespace angiopose::io {

/// Trial in which an observer registered the vessels manually without seeing any metrics.
struct ObserverTrial {
    std::string startedAt;   ///< start time, ISO 8601, UTC
    std::string observer;
    std::string caseTitle;
    std::string imageSha256;
    int frame = 0;
    std::uint64_t seed = 0;   ///< random seed of the initial pose
    double rangeMm = 0.0;   ///< bound of the random initial offset along each axis (±)
    double rangeDeg = 0.0;   ///< bound of the random initial rotation about each axis (±)
    double durationS = 0.0;
    int editCount = 0;   ///< number of undo steps: moves, drags, typed values
    bool isAbandoned = false;
    core::RigidTransform initialPose;   ///< initial cameraFromPatient
    core::RigidTransform finalPose;
    core::RigidTransform centerPose;   ///< pose before the trial, about which the initial pose was randomized
    Eigen::Vector3d pivotInPatient = Eigen::Vector3d::Zero();   ///< centroid of the vessel tree
};

/// Appends the trial as a row to a CSV file; creates the file with a header if needed. Fails if the file is not an
/// observer log.
core::Status appendTrial(const ObserverTrial& trial, const std::string& path);

}   // namespace angiopose::io
