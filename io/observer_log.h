#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/support/result.h"

#include <cstdint>
#include <string>

namespace angiopose::io {

/// One trial of an observer who registered the vessels manually without seeing numbers.
struct ObserverTrial {
    std::string startedAt;   ///< ISO 8601, UTC
    std::string observer;
    std::string caseTitle;
    std::string imageSha256;
    int frame = 0;
    std::uint64_t seed = 0;   ///< random seed of the initial pose
    double rangeMm = 0.0;   ///< initial offset within ± this along each axis …
    double rangeDeg = 0.0;   ///< … and initial rotation within ± this about each
    double durationS = 0.0;
    int editCount = 0;   ///< undo steps: moves, drags, typed numbers
    bool isAbandoned = false;
    core::RigidTransform initialPose;   ///< cameraFromPatient
    core::RigidTransform finalPose;
    core::RigidTransform centerPose;   ///< center of the range: the pose before the trial
    Eigen::Vector3d pivotInPatient = Eigen::Vector3d::Zero();   ///< centroid of the tree
};

/// Appends the trial as a row to a comma-separated table, which gets a header when it is created. Fails if the file is
/// something else.
core::Status appendTrial(const ObserverTrial& trial, const std::string& path);

}   // namespace angiopose::io