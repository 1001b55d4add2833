#pragma once

#include "core/evaluation/trial/projection_error.h"
#include "core/registration/registration.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::core {

inline constexpr double unknownMeasure = std::numeric_limits<double>::quiet_NaN();

/// Performance of one method in one trial. If there is no result, the errors are those of the initial pose. Lengths in
/// px refer to the image, lengths in mm to the depth of the tree's centroid; projection_error.h defines the errors.
struct RunRecord {
    std::string condition;   ///< Condition::id
    std::string method;   ///< EvaluatedMethod::label
    std::uint64_t trial = 0;
    int anatomy = 0;

    // Errors of the initial pose
    double startMeanPx = unknownMeasure;
    double startMtreMm = unknownMeasure;
    double startAngleDeg = unknownMeasure;
    // Output of the method
    double hasResult = 0.0;   ///< 1 if the method returned a result, otherwise 0
    double trustworthy = 0.0;   ///< 1 if the result is rated as reliable, otherwise 0
    double iterations = 0.0;
    double closestMedianPx = unknownMeasure;   ///< the seed's "TRE": distance of tree points to nearest target point
    double closestMeanPx = unknownMeasure;   ///< the seed's "PR", as in its figures
    double reverseMeanPx = unknownMeasure;   ///< target points to the nearest tree point
    double coverage = unknownMeasure;
    // Errors relative to the ground truth
    double meanPx = unknownMeasure, rmsPx = unknownMeasure, medianPx = unknownMeasure, p75Px = unknownMeasure,
           p95Px = unknownMeasure;   ///< projection distances between corresponding points
    double meanMm = unknownMeasure;
    double fractionAbove5Px = unknownMeasure;   ///< fraction of the tree points
    double mtreMm = unknownMeasure, mtreInPlaneMm = unknownMeasure, mrpdMm = unknownMeasure;
    double angleDeg = unknownMeasure, outOfPlaneDeg = unknownMeasure, inPlaneDeg = unknownMeasure;
    double seedDistanceMm = unknownMeasure;
    double centroidInPlaneMm = unknownMeasure, centroidDepthMm = unknownMeasure;
    double nees = unknownMeasure;   ///< eᵀΣ⁻¹e of the reported covariance
    double boundRmsPx = unknownMeasure;   ///< rms projection distance at the Cramér–Rao bound
    // Times, which differ from run to run
    double traceMs = unknownMeasure, targetMs = unknownMeasure, searchMs = unknownMeasure, solveMs = unknownMeasure,
           totalMs = unknownMeasure;
    double processorMs = unknownMeasure;   ///< CPU time of the thread that ran the registration

    std::vector<double> history;   ///< mean projection distance in px at each progress report; only in the first trials
};

/// A numeric field of a run record; tables, files and plots iterate over these fields.
struct RunField {
    std::string_view name;   ///< column in files
    double RunRecord::*value = nullptr;
    bool isTime = false;   ///< whether it is a time; times are not reproducible and are stored in a separate file
};

std::span<const RunField> runFields();

/// All runs of one protocol and seed, ordered by condition, trial and method.
struct RunSet {
    std::string protocol;
    std::uint64_t seed = 1;
    std::vector<RunRecord> runs;
};

/// Ground truth with which a pose is compared.
struct GroundTruth {
    const VesselTree& tree;   ///< projection distances are measured on its points
    const ProjectionCamera& camera;
    RigidTransform cameraFromPatient;
    std::vector<Eigen::Vector3d> targetsInPatient;   ///< target points for mTRE and mRPD
    /// True positions of nonrigidly deformed vessels at `cameraFromPatient`, point by point as in `tree`. If set,
    /// distances are measured to this tree and its points are the targets; null for rigid vessels.
    const VesselTree* deformedTree = nullptr;
};

/// Computes the errors of the initial pose.
void measureInitialPose(const GroundTruth& truth, const RigidTransform& start, RunRecord& record);

/// Computes the errors of the estimated pose: projection distances, target errors and pose errors.
void measurePose(const GroundTruth& truth, const RigidTransform& found, RunRecord& record);

/// Computes the errors of a deformed tree at the estimated pose. Distances and target errors are those of the deformed
/// tree if the true deformation is known, otherwise those of the rigid tree.
void measureDeformed(const GroundTruth& truth, const RigidTransform& found, const VesselTree& deformed,
                     RunRecord& record);

/// Computes the normalized squared error of the pose from its reported covariance.
void measureCovariance(const GroundTruth& truth, const RegistrationResult& result, RunRecord& record);

/// Copies the quality measures and times reported by the method, which require no ground truth.
void recordResult(const RegistrationResult& result, RunRecord& record);

/// One registration of an experiment: the input of the methods and the ground truth for the evaluation.
struct Trial {
    RegistrationInput input;
    std::shared_ptr<const VesselTree> tree;   ///< errors are computed at its points; input.tree may lack branches
    RigidTransform trueCameraFromPatient;
    bool hasCorrectPose = true;   ///< false if no pose is correct, so that the errors are unknown
    bool targetIsExact = false;   ///< whether every target point is the projection of a tree point
    std::optional<Matrix6d> errorBound;   ///< Cramér–Rao covariance about the tree's centroid, if known
    std::optional<double> traceMs;   ///< time for tracing the target, if it was traced from an image
};

}   // namespace angiopose::core
