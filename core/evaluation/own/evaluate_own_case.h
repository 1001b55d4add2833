#pragma once

#include "core/evaluation/trial/run_record.h"
#include "core/registration/registration.h"

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

namespace angiopose::core {

/// A point marked in both the patient and the image.
struct PointPair {
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< LPS, mm
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// Ground truth of a user's case: a reference pose, or point pairs if there is none.
struct OwnGroundTruth {
    std::optional<RigidTransform> cameraFromPatient;
    std::vector<Eigen::Vector3d> landmarksInPatient;   ///< targets of mTRE and mRPD; empty: the tree's, see targetsOf
    std::vector<PointPair> pairs;
    /// Optional, in addition to a reference pose: true positions of nonrigidly displaced vessels (see GroundTruth).
    std::shared_ptr<const VesselTree> deformedTree;
};

/// Whether a deformed ground truth matches a tree: the same branches, in the same order, with as many points.
bool isGroundTruthFor(const VesselTree& deformed, const VesselTree& tree);

/// A case whose result is evaluated.
struct OwnCase {
    const VesselTree& tree;
    const ProjectionCamera& camera;
    RigidTransform startCameraFromPatient;
    OwnGroundTruth truth;
};

/// Computes the errors of a method's result, or of the initial pose if there is no result. A reference pose gives all
/// errors (ALGORITHMS §4.5), including those of the deformed tree if the true vessel positions are known. With point
/// pairs only, PR is the distance of a projected point to its pixel and mRPD the distance of the point to the ray
/// through its pixel; mTRE and angle errors stay unknown.
RunRecord evaluateOwnCase(const OwnCase& own, const std::optional<RegistrationResult>& result);

/// Overload for a pose found by other means; the confidence is unknown.
RunRecord evaluateOwnCase(const OwnCase& own, const RigidTransform& found);

}   // namespace angiopose::core
