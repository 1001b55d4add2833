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
};

/// Errors of the start pose.
void measureStart(const Truth& truth, const RigidTransform& start, RunRecord& record);

/// Errors of the pose that was found: projection distances, target errors, and those of the pose itself.
void measurePose(const Truth& truth, const RigidTransform& found, RunRecord& record);

/// The normalised squared error of the pose by its reported covariance.
void measureCovariance(const Truth& truth, const RegistrationResult& result, RunRecord& record);

/// What the method says of itself, without any truth.
void noteResult(const RegistrationResult& result, RunRecord& record);

}   // namespace angiopose::core
