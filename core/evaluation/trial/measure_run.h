#pragma once

#include "core/evaluation/trial/projection_error.h"
#include "core/evaluation/trial/run_record.h"
#include "core/registration/registration.h"

#include <vector>

namespace angiopose::core {

/// What a pose is judged by, where the true one is known.
struct Truth {
    const VesselTree& tree;   ///< projection distances are measured on its points
    const ProjectionCamera& camera;
    RigidTransform cameraFromPatient;
    std::vector<Eigen::Vector3d> targetsInPatient;   ///< of mTRE and mRPD
    /// Where vessels that are no rigid body truly lay, point for point those of `tree`, as seen with
    /// `cameraFromPatient`: then distances are measured to it, and its points are the targets. Null: as `tree`.
    const VesselTree* bentTree = nullptr;
};

/// Errors of the start pose.
void measureStart(const Truth& truth, const RigidTransform& start, RunRecord& record);

/// Errors of the pose that was found: projection distances, target errors, and those of the pose itself.
void measurePose(const Truth& truth, const RigidTransform& found, RunRecord& record);

/// The same of a tree that was bent, as seen with the pose that was found: distances and target errors are those of the
/// bent tree where it is known how the vessels lay, else of the rigid one.
void measureBent(const Truth& truth, const RigidTransform& found, const VesselTree& bent, RunRecord& record);

/// The normalised squared error of the pose by its reported covariance.
void measureCovariance(const Truth& truth, const RegistrationResult& result, RunRecord& record);

/// What the method says of itself, without any truth.
void noteResult(const RegistrationResult& result, RunRecord& record);

}   // namespace angiopose::core
