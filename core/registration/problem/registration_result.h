#pragma once

#include "core/geometry/camera_spread.h"
#include "core/geometry/patient_position.h"
#include "core/geometry/rigid_transform.h"
#include "core/imaging/angiogram.h"
#include "core/registration/options/registration_options.h"
#include "core/registration/problem/wire_path.h"
#include "core/support/result.h"
#include "core/support/verdict.h"
#include "core/vessel/centerline2d.h"
#include "core/vessel/vessel_tree.h"

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

struct Volume;
struct DeformableResult;

/// Complete input of one registration, by value: a snapshot that no one else modifies. Large members are shared.
struct RegistrationInput {
    VesselTree tree;
    Centerline2d target;
    ProjectionCamera camera;
    RigidTransform initialCameraFromPatient;
    std::optional<RigidTransform> lockReference{};   ///< reference of locked angles; nullopt: the initial pose
    std::optional<Eigen::Vector3d> lockPivotInPatient{};   ///< pivot of locked shifts; nullopt: the centroid
    std::vector<int> auxiliaryBranchIds{};   ///< {p'}; empty means the nodes
    std::vector<int> excludedBranchIds{};   ///< ignored completely
    std::shared_ptr<const ImageF>
        image{};   ///< frame that shows the target; null: intensity-based methods render the target
    Polarity polarity = Polarity::VesselsDark;   ///< polarity of `image`
    std::shared_ptr<const Mask2d> shutter{};   ///< shutter of `image`, see Angiogram::shutter; null: none
    std::shared_ptr<const Volume> volume{};   ///< CTA that shows the tree; null: radiographs are simulated from tubes
    CameraSpread cameraSpread{};   ///< standard deviations of the camera errors; zero: exact
    std::optional<TableReading>
        tableReading{};   ///< alternative interpretation of the angles for a different patient position
};

enum class StopReason { Converged, IterationLimit, NoImprovement, StoppedByUser };

/// Step of a running registration, for progress, the live overlay and the convergence plot.
struct IterationReport {
    int iteration = 0;
    std::string_view stage;   ///< "search", "refine", "rotation", "auxiliary", …
    double progress = 0.0;   ///< 0…1, never decreasing
    double scalePx = 0.0;   ///< current kernel width
    double medianDistancePx = 0.0;   ///< from the tree points to their nearest target point
    double stepMm = 0.0;   ///< RMS shift of the tree's points since the previous report or the start
    RigidTransform cameraFromPatient;   ///< best pose so far
    std::size_t view = 0;   ///< index of the pose's view among the views registered jointly
};

using IterationObserver = std::function<Verdict(const IterationReport&)>;

/// Agreement of one branch with the image.
struct BranchResidual {
    int branchId = 0;
    int pointCount = 0;
    double medianPx = 0.0;
    double p95Px = 0.0;
    double agreement = 0.0;   ///< share of its points within 3 px of the traced vessels, 0…1
};

/// Branch that appears unopacified in the image: a candidate for exclusion.
struct UnopacifiedBranch {
    int branchId = 0;
    double share = 0.0;   ///< unopacified share of its length inside the image, 0…1
};

/// Closest-point distances over all used tree points (without unopacified ones), and the reverse direction (ALGORITHMS
/// §4.5).
struct DistanceMetrics {
    double meanPx = 0.0, medianPx = 0.0, p75Px = 0.0, p95Px = 0.0;
    double meanMm = 0.0, medianMm = 0.0, p75Mm = 0.0, p95Mm = 0.0;   ///< at the depth of the tree's centroid
    double coverage = 0.0;   ///< share of target points within 3 px of the projected tree
    double reverseMeanPx = 0.0, reverseMeanMm = 0.0;
};

/// Pose covariance about the tree's centroid (centroidInPatient of the whole tree, whatever is excluded) in camera axes
/// (ALGORITHMS §6.10).
/// Order: rotation x, y, z (rad), translation x, y, z (mm); x right, y down on the detector up to sign, z along the
/// ray.
struct PoseUncertainty {
    Matrix6d covariance = Matrix6d::Zero();   ///< including the contribution of camera errors
    Matrix6d imageCovariance = Matrix6d::Zero();   ///< without camera errors
    Eigen::Vector3d rotationDeg = Eigen::Vector3d::Zero();   ///< 1-σ about camera x, y, z
    double inPlaneMm = 0.0;   ///< 1-σ, larger of the two in-plane directions
    double depthMm = 0.0;   ///< 1-σ along the ray
    std::array<bool, 6> observed{};   ///< false: the image does not determine this degree of freedom
    Vector6d weakestDirection = Vector6d::Zero();   ///< unit vector, same order, in (ρ·rad, mm)
};

/// Evidence of the images for the error of a camera (ALGORITHMS §6.18).
struct CameraEvidence {
    CameraError error = CameraError::Zero();   ///< most likely error, given the prior of the camera
    CameraError std = CameraError::Zero();   ///< remaining 1-σ
    double gain = 0.0;   ///< improvement by all errors together: decrease of −2 log of the posterior

    bool operator==(const CameraEvidence&) const = default;
};

/// Wall times of a registration.
struct StageTimes {
    static constexpr double notMeasured = std::numeric_limits<double>::quiet_NaN();

    double targetMs = 0.0;
    double searchMs = 0.0;
    double solveMs = 0.0;
    double totalMs = 0.0;   ///< from curves to the judged pose, excluding the preceding reading and tracing
    double readMs = notMeasured;   ///< reading the files
    double traceMs = notMeasured;   ///< tracing the view's vessels in the image
};

/// Alternative pose that explains the image nearly as well.
struct Hypothesis {
    RigidTransform cameraFromPatient;
    double score = 0.0;   ///< 0…1, higher is better, comparable within one result
};

/// Signs for estimating the error of a fit without the ground truth (ALGORITHMS §6.21).
struct FitSigns {
    double agreement = 0.0;   ///< in both directions, 0…1 (§6.8); only of the opacified parts where only these count
    double treeShare = 0.0;   ///< share of the tree's points along traced vessels
    double inViewShare = 0.0;   ///< share of the tree's points inside the image
    double followedShare = 0.0;   ///< share of the tree's length inside the image that runs along vessels
    double followedMm = 0.0;   ///< length of that share
    int followedBranches = 0;
    double settlingMm = 0.0;   ///< shift of the pose when refined in place
    double expectedErrorMm = 0.0;   ///< from the covariance of a rigid tree, 1-σ
    double rivalMm = 0.0;   ///< displacement of the tree in the farthest alternative
    bool isPartlyOpacified = false;
    int filledForks = 0;   ///< for a partly opacified tree: places where three or more opacified pieces meet
    bool isSinglePath = false;   ///< no three pieces on vessels meet anywhere
    bool isLumen = false;   ///< widths indicate opacified vessels, not a wire or catheter; also false if unknown
};

/// Operator, time, program version and inputs of a result.
struct Provenance {
    std::string author;   ///< empty: unknown
    std::string time;   ///< ISO 8601, UTC; empty: unknown
    std::string programVersion;   ///< empty: unknown
    RegistrationOptions options;
    std::optional<int>
        frame{};   ///< frame of the angiogram, counts from 0; the assessment of the fit applies only to it
    std::optional<RigidTransform> start{};   ///< initial camera-from-patient transform; nullopt: unknown
};

struct RegistrationResult {
    std::string method;
    RigidTransform cameraFromPatient;
    StopReason stopReason = StopReason::IterationLimit;
    int iterations = 0;
    DistanceMetrics metrics;
    PoseUncertainty uncertainty;
    std::optional<CameraEvidence> camera;   ///< nullopt: the camera counts as exact
    std::vector<BranchResidual> branches;   ///< used branches, in the tree's order
    std::vector<UnopacifiedBranch> unopacified;   ///< in the tree's order; the pose is based on the other branches
    std::vector<Hypothesis> alternatives;   ///< best first, without the result itself
    std::vector<WirePath> wirePaths;   ///< from the wire method: the solution's path first, then the alternatives
    /// Deformation of the vessels from this pose; null: not computed. With several jointly registered views, each
    /// result has it with its own view as the first (MultiViewResult: one for all).
    std::shared_ptr<const DeformableResult> deformed;
    std::vector<IterationReport> history;   ///< for the convergence plot
    FitSigns signs;
    /// Probability that the overlay lies within 2 mm of the vessels on average over the tree (ALGORITHMS §6.21).
    /// nullopt for methods other than the default, for several views and for manually set poses, where it is unknown.
    std::optional<double> probabilityWithin2Mm;
    bool trustworthy = false;
    Messages warnings;   ///< reasons for low confidence, or quantities that one view cannot determine
    StageTimes time;
    Provenance provenance;   ///< for results stored in a case: see registerCase
};

}   // namespace angiopose::core
