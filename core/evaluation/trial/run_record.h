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

/// Performance of one method in one trial. Without a result the errors are those of the initial pose. Lengths in px are
/// in the image, lengths in mm at the depth of the tree's centroid; errors as in evaluation/projection_error.
struct RunRecord {
    std::string condition;   ///< Condition::id
    std::string method;   ///< Contestant::label
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
    double closestMeanPx = unknownMeasure;   ///< the seed's "PR", as its figures show
    double reverseMeanPx = unknownMeasure;   ///< target points to the nearest tree point
    double coverage = unknownMeasure;
    // What is true
    double meanPx = unknownMeasure, rmsPx = unknownMeasure, medianPx = unknownMeasure, p75Px = unknownMeasure,
           p95Px = unknownMeasure;   ///< projection distances to the true partners
    double meanMm = unknownMeasure;
    double shareAbove5Px = unknownMeasure;   ///< of the tree points
    double mtreMm = unknownMeasure, mtreInPlaneMm = unknownMeasure, mrpdMm = unknownMeasure;
    double angleDeg = unknownMeasure, outOfPlaneDeg = unknownMeasure, inPlaneDeg = unknownMeasure;
    double seedDistanceMm = unknownMeasure;
    double centroidInPlaneMm = unknownMeasure, centroidDepthMm = unknownMeasure;
    double nees = unknownMeasure;   ///< eᵀΣ⁻¹e of the reported covariance
    double boundRmsPx = unknownMeasure;   ///< rms projection distance at the Cramér–Rao bound
    // Differs from run to run
    double traceMs = unknownMeasure, targetMs = unknownMeasure, searchMs = unknownMeasure, solveMs = unknownMeasure,
           totalMs = unknownMeasure;
    double processorMs = unknownMeasure;   ///< of the thread that registered

    std::vector<double> history;   ///< mean projection distance in px after each report; the first trials only
};

/// One number of a record: tables, files and plots loop over these.
struct RunField {
    std::string_view name;   ///< column in files
    double RunRecord::*value = nullptr;
    bool isTime = false;   ///< not repeatable, kept in a file of its own
};

std::span<const RunField> runFields();

/// All runs of one protocol and seed, ordered by condition, trial and method.
struct RunSet {
    std::string protocol;
    std::uint64_t seed = 1;
    std::vector<RunRecord> runs;
};

/// What a pose is judged by, where the true one is known.
struct Truth {
    const VesselTree& tree;   ///< projection distances are measured on its points
    const ProjectionCamera& camera;
    RigidTransform cameraFromPatient;
    std::vector<Eigen::Vector3d> targetsInPatient;   ///< of mTRE and mRPD
    /// Where vessels that are no rigid body truly lay, point for point those of `tree`, as seen with
    /// `cameraFromPatient`: then distances are measured to it, and its points are the targets. Null: as `tree`.
    const VesselTree* deformedTree = nullptr;
};

/// Errors of the start pose.
void measureStart(const Truth& truth, const RigidTransform& start, RunRecord& record);

/// Errors of the pose that was found: projection distances, target errors, and those of the pose itself.
void measurePose(const Truth& truth, const RigidTransform& found, RunRecord& record);

/// The same of a tree that was bent, as seen with the pose that was found: distances and target errors are those of the
/// bent tree where it is known how the vessels lay, else of the rigid one.
void measureDeformed(const Truth& truth, const RigidTransform& found, const VesselTree& deformed, RunRecord& record);

/// The normalised squared error of the pose by its reported covariance.
void measureCovariance(const Truth& truth, const RegistrationResult& result, RunRecord& record);

/// What the method says of itself, without any truth.
void noteResult(const RegistrationResult& result, RunRecord& record);

/// One registration of an experiment: what the methods get, and what only the judge knows.
struct Trial {
    RegistrationInput input;
    std::shared_ptr<const VesselTree> tree;   ///< errors are measured on its points; input.tree may lack branches
    RigidTransform trueCameraFromPatient;
    bool hasRightAnswer = true;   ///< false: no pose is right, a method can only say so; its errors stay unknown
    bool targetIsExact = false;   ///< every target point is the projection of a tree point
    std::optional<Matrix6d> errorBound;   ///< Cramér–Rao covariance about the tree's centroid, where it is known
    std::optional<double> traceMs;   ///< to get the target from the image, where there was one
};

}   // namespace angiopose::core
