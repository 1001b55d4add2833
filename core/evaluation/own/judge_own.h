#pragma once

#include "core/evaluation/trial/run_record.h"
#include "core/registration/registration.h"

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

namespace angiopose::core {

/// A place that was pointed at in the patient and in the image.
struct PointPair {
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< LPS, mm
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// What somebody knows of a case of theirs: a reference pose, or pairs of points where there is none.
struct OwnTruth {
    std::optional<RigidTransform> cameraFromPatient;
    std::vector<Eigen::Vector3d> landmarksInPatient;   ///< targets of mTRE and mRPD; empty: the tree's, see targetsOf
    std::vector<PointPair> pairs;
    /// Beside a reference pose: where the vessels truly lay when they were no rigid body, see Truth.
    std::shared_ptr<const VesselTree> deformedTree;
};

/// Whether the truth of bent vessels goes with a tree: the same branches with as many points each, in the same order.
bool isTruthOf(const VesselTree& deformed, const VesselTree& tree);

/// A case whose answer is judged.
struct OwnCase {
    const VesselTree& tree;
    const ProjectionCamera& camera;
    RigidTransform startCameraFromPatient;
    OwnTruth truth;
};

/// Errors of a method's result, or of the start pose where it has none. With a reference pose all of them
/// (ALGORITHMS §4.5), of the tree as the result bent it where it is known how the vessels lay; with pairs alone PR is
/// the distance of a projected point to its pixel, mRPD that of the point to the ray through its pixel, and depth
/// errors (mTRE, angles) stay unknown.
RunRecord judgeOwn(const OwnCase& own, const std::optional<RegistrationResult>& result);

/// The same of a pose that was found elsewhere; whether it is to be trusted is not known.
RunRecord judgeOwn(const OwnCase& own, const RigidTransform& found);

}   // namespace angiopose::core
