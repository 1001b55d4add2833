#pragma once

#include "core/geometry/camera_uncertainty.h"
#include "core/geometry/patient_position.h"
#include "core/geometry/rigid_transform.h"
#include "core/imaging/angiogram.h"
#include "core/registration/options/registration_options.h"
#include "core/registration/problem/wire_path.h"
#include "core/support/observer_decision.h"
#include "core/support/result.h"
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

/// Complete input of one registration, as a copy that no other code modifies. Large members are shared.
struct RegistrationInput {
    VesselTree tree;
    Centerline2d target;
    ProjectionCamera camera;
    RigidTransform initialCameraFromPatient;
    std::optional<RigidTransform> lockReference{};   ///< reference of locked angles; nullopt means the initial pose
    std::optional<Eigen::Vector3d> lockPivotInPatient{};   ///< pivot of locked shifts; nullopt means the centroid
    std::vector<int> auxiliaryBranchIds{};   ///< branches of {p'}; if empty, the nodes are used
    std::vector<int> excludedBranchIds{};   ///< branches that the registration ignores
    std::shared_ptr<const ImageF>
        image{};   ///< frame in which the target was traced; if null, intensity-based methods render the target
    Polarity polarity = Polarity::VesselsDark;   ///< polarity of `image`
    std::shared_ptr<const Mask2d> shutter{};   ///< shutter of `image`, see Angiogram::shutter; null if there is none
    std::shared_ptr<const Volume> volume{};   ///< CTA that shows the tree; if null, DRRs are rendered from tubes
    CameraUncertainty cameraUncertainty{};   ///< standard deviations of the camera errors; zero for an exact camera
    std::optional<TableAngles>
        tableAngles{};   ///< alternative initial angles, for a gantry that reports its angles relative to the table
};

enum class StopReason { Converged, IterationLimit, NoImprovement, StoppedByUser };

/// Step of a running registration, for progress, the live overlay and the convergence plot.
struct IterationReport {
    int iteration = 0;
    std::string_view stage;   ///< "search", "refine", "rotation", "auxiliary", …
    double progress = 0.0;   ///< 0…1, never decreasing
    double scalePx = 0.0;   ///< current kernel width
    double medianDistancePx = 0.0;   ///< median distance from the tree points to their nearest target points
    double stepMm = 0.0;   ///< RMS shift of the tree points since the previous report or the initial pose
    RigidTransform cameraFromPatient;   ///< best pose so far
    std::size_t view = 0;   ///< index of the view to which the pose belongs, if several views are registered jointly
};

using IterationObserver = std::function<ObserverDecision(const IterationReport&)>;

/// Agreement of one branch with the image.
struct BranchResidual {
    int branchId = 0;
    int pointCount = 0;
    double medianPx = 0.0;
    double p95Px = 0.0;
    double agreement = 0.0;   ///< fraction of the branch points within 3 px of the traced vessels, 0…1
};

/// Branch that appears unopacified in the image and may be excluded.
struct UnopacifiedBranch {
    int branchId = 0;
    double share = 0.0;   ///< unopacified fraction of the branch length inside the image, 0…1
};

/// Distances from all used tree points, except unopacified ones, to the nearest point of the target, and in the reverse
/// direction (ALGORITHMS §4.5).
struct DistanceMetrics {
    double meanPx = 0.0, medianPx = 0.0, p75Px = 0.0, p95Px = 0.0;
    double meanMm = 0.0, medianMm = 0.0, p75Mm = 0.0, p95Mm = 0.0;   ///< at the depth of the tree's centroid
    double coverage = 0.0;   ///< fraction of the target points within 3 px of the projected tree
    double reverseMeanPx = 0.0, reverseMeanMm = 0.0;
};

/// Pose covariance in camera axes about the centroid of the whole tree, including excluded branches (centroidInPatient;
/// ALGORITHMS §6.10). Order: rotation x, y, z (rad), translation x, y, z (mm); x is to the right and y down on the
/// detector (up to sign), z along the ray.
struct PoseUncertainty {
    Matrix6d covariance = Matrix6d::Zero();   ///< includes the contribution of camera errors
    Matrix6d imageCovariance = Matrix6d::Zero();   ///< excludes camera errors
    Eigen::Vector3d rotationDeg = Eigen::Vector3d::Zero();   ///< 1-σ about camera x, y, z
    double inPlaneMm = 0.0;   ///< 1-σ in the less certain in-plane direction
    double depthMm = 0.0;   ///< 1-σ along the ray
    std::array<bool, 6> observed{};   ///< per degree of freedom, whether the image determines it
    Vector6d weakestDirection = Vector6d::Zero();   ///< unit vector, same order, in (ρ·rad, mm)
};

/// Evidence that the images provide about the errors of a camera (ALGORITHMS §6.18).
struct CameraEvidence {
    CameraError error = CameraError::Zero();   ///< most likely error, given the prior of the camera
    CameraError std = CameraError::Zero();   ///< 1-σ of the estimated error
    double gain = 0.0;   ///< decrease of −2 log posterior due to the errors of all cameras together

    bool operator==(const CameraEvidence&) const = default;
};

/// Wall times of a registration.
struct StageTimes {
    static constexpr double notMeasured = std::numeric_limits<double>::quiet_NaN();

    double targetMs = 0.0;
    double searchMs = 0.0;
    double solveMs = 0.0;
    double totalMs = 0.0;   ///< from the traced curves to the assessed pose, excluding reading and tracing
    double readMs = notMeasured;   ///< time for reading the files
    double traceMs = notMeasured;   ///< time for tracing the vessels in this view
};

/// Alternative pose that explains the image nearly as well as the result.
struct Hypothesis {
    RigidTransform cameraFromPatient;
    double score = 0.0;   ///< 0…1, higher is better; comparable only within one result
};

/// Indicators for estimating the error of a fit without ground truth (ALGORITHMS §6.21).
struct FitIndicators {
    double agreement = 0.0;   ///< in both directions, 0…1 (§6.8); for a partly opacified tree, of the opacified parts
    double treeFraction = 0.0;   ///< fraction of the tree points along traced vessels
    double inViewFraction = 0.0;   ///< fraction of the tree points inside the image
    double followedShare = 0.0;   ///< fraction of the tree length inside the image that follows traced vessels
    double followedMm = 0.0;   ///< tree length that follows traced vessels
    int followedBranches = 0;
    double refinementMm = 0.0;   ///< shift of the pose when refined in place, see refinementShiftMm
    double expectedErrorMm = 0.0;   ///< 1-σ displacement from the covariance of a rigid tree
    double alternativeMm = 0.0;   ///< displacement of the tree between the result and the farthest alternative
    bool isPartlyOpacified = false;
    int opacifiedBifurcations =
        0;   ///< for a partly opacified tree: bifurcations where three or more opacified segments meet
    bool isSinglePath = false;   ///< whether the matched segments form a single path without bifurcations
    bool isLumen = false;   ///< whether the widths indicate opacified vessels, not a wire or catheter; false if unknown
};

/// Operator, time, program version, options, frame and initial pose behind a result.
struct Provenance {
    std::string author;   ///< empty if unknown
    std::string time;   ///< ISO 8601, UTC; empty if unknown
    std::string programVersion;   ///< empty if unknown
    RegistrationOptions options;
    std::optional<int> frame{};   ///< frame of the angiogram, starting at 0, to which alone the assessment applies
    std::optional<RigidTransform> start{};   ///< initial camera-from-patient transform; nullopt if unknown
};

struct RegistrationResult {
    std::string method;
    RigidTransform cameraFromPatient;
    StopReason stopReason = StopReason::IterationLimit;
    int iterations = 0;
    DistanceMetrics metrics;
    PoseUncertainty uncertainty;
    std::optional<CameraEvidence> camera;   ///< nullopt if the camera is treated as exact
    std::vector<BranchResidual> branches;   ///< used branches, in the tree's order
    std::vector<UnopacifiedBranch> unopacified;   ///< in the tree's order; the pose was fitted to the other branches
    std::vector<Hypothesis> alternatives;   ///< best first, excluding the result itself
    std::vector<WirePath> wirePaths;   ///< only from the wire method: path of the solution, then the alternatives
    /// Deformation of the vessels relative to this pose; null if not computed. After joint registration of several
    /// views, each result stores it with its own view first; MultiViewResult stores it once for all views.
    std::shared_ptr<const DeformableResult> deformed;
    std::vector<IterationReport> history;   ///< for the convergence plot
    FitIndicators indicators;
    /// Probability that the overlay lies within 2 mm of the vessels, averaged over the tree (ALGORITHMS §6.21). Unknown
    /// (nullopt) for methods other than the default, for several views and for manually set poses.
    std::optional<double> probabilityWithin2Mm;
    bool trustworthy = false;
    Messages warnings;   ///< reasons for low confidence, or quantities that one view cannot determine
    StageTimes time;
    Provenance provenance;   ///< set for results stored in a case, see registerCase
};

}   // namespace angiopose::core
