#pragma once

#include "core/registration/pose_snapshot.h"
#include "core/support/result.h"

#include <span>
#include <string>

namespace angiopose::io {

/// The upper three rows of a pose's matrix as comma-separated cells, row-major.
std::string poseCells(const core::RigidTransform& cameraFromPatient);

/// Snapshots as a comma-separated table, one row each: what is known of them, how far each lies from `reference` about
/// `pivotInPatient` (see core::PoseDifference), and the pose as 12 numbers, row-major, cameraFromPatient. Texts in
/// quotes may hold commas and line breaks; what is not known stays empty.
std::string snapshotTable(std::span<const core::PoseSnapshot> snapshots, const core::PoseSnapshot& reference,
                          const Eigen::Vector3d& pivotInPatient);

core::Status writeSnapshotTable(std::span<const core::PoseSnapshot> snapshots, const core::PoseSnapshot& reference,
                                const Eigen::Vector3d& pivotInPatient, const std::string& path);

}   // namespace angiopose::io