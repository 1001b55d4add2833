#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/support/result.h"

#include <cstdint>
#include <string>

namespace angiopose::io {

/// One trial of an observer who fitted the vessels by hand without seeing numbers.
struct ObserverTrial {
    std::string startedAt;   ///< ISO 8601, UTC
    std::string observer;
    std::string caseTitle;
    std::string imageSha256;
    int frame = 0;
    std::uint64_t seed = 0;   ///< of the start pose
    double rangeMm = 0.0;   ///< the start lay within ± this along each axis …
    double rangeDeg = 0.0;   ///< … and was turned within ± this about each
    double durationS = 0.0;
    int editCount = 0;   ///< steps of undo: moves, drags, typed numbers
    bool isAbandoned = false;
    core::RigidTransform startPose;   ///< cameraFromPatient
    core::RigidTransform finalPose;
    core::RigidTransform centerPose;   ///< of the range: the pose before the trial
    Eigen::Vector3d pivotInPatient = Eigen::Vector3d::Zero();   ///< centroid of the tree
};

/// Adds the trial as a row to a comma-separated table, begun with a header where there is none yet. Fails when the
/// file is something else.
core::Status appendTrial(const ObserverTrial& trial, const std::string& path);

}   // namespace angiopose::io