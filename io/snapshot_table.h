#pragma once

#include "core/registration/pose_snapshot.h"
#include "core/support/result.h"

#include <span>
#include <string>

namespace angiopose::io {

/// Returns the upper three rows of a pose matrix as comma-separated cells, row-major.
std::string poseCells(const core::RigidTransform& cameraFromPatient);

/// Returns snapshots as CSV, one row each: properties, difference from `reference` about `pivotInPatient` (see
/// core::PoseDifference), and the pose cameraFromPatient as 12 numbers, row-major. Strings that contain commas or line
/// breaks are quoted; unknown values are empty.
std::string snapshotTable(std::span<const core::PoseSnapshot> snapshots, const core::PoseSnapshot& reference,
                          const Eigen::Vector3d& pivotInPatient);

core::Status writeSnapshotTable(std::span<const core::PoseSnapshot> snapshots, const core::PoseSnapshot& reference,
                                const Eigen::Vector3d& pivotInPatient, const std::string& path);

}   // namespace angiopose::io
