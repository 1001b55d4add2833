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

/// Everything one registration needs, by value: a snapshot that no one else writes to. The large ones are shared.
struct RegistrationInput {
    VesselTree tree;
    Centerline2d target;
    ProjectionCamera camera;
    RigidTransform initialCameraFromPatient;
    std::optional<RigidTransform> lockReference{};   ///< what locked angles are counted from; nothing: the start
    std::optional<Eigen::Vector3d> lockPivotInPatient{};   ///< whose place locked shifts keep; nothing: the centroid
    std::vector<int> auxiliaryBranchIds{};   ///< {p'}; empty means the nodes
    std::vector<int> excludedBranchIds{};   ///< not used at all
    std::shared_ptr<const ImageF> image{};   ///< the frame that shows the target; null: image methods draw the target
    Polarity polarity = Polarity::VesselsDark;   ///< of `image`
    std::shared_ptr<const Mask2d> shutter{};   ///< of `image`, see Angiogram::shutter; null: none
    std::shared_ptr<const Volume> volume{};   ///< the CTA that shows the tree; null: radiographs are made of tubes
    CameraSpread cameraSpread{};   ///< how far the camera may be off; zero: it is exact
    std::optional<TableReading>
        tableReading{};   ///< how else the angles may be meant, for a patient who lies otherwise
};

enum class StopReason { Converged, IterationLimit, NoImprovement, StoppedByUser };

/// One step of a running registration, for progress, the live overlay and the convergence plot.
struct IterationReport {
    int iteration = 0;
    std::string_view stage;   ///< "search", "refine", "rotation", "auxiliary", …
    double progress = 0.0;   ///< 0…1, never decreasing
    double scalePx = 0.0;   ///< current kernel width
    double medianDistancePx = 0.0;   ///< tree points to their nearest target point
    double stepMm = 0.0;   ///< rms shift of the tree's points since the report before, or since the start
    RigidTransform cameraFromPatient;   ///< best pose so far
    std::size_t view = 0;   ///< whose pose: place among the views that are registered together
};

using IterationObserver = std::function<Verdict(const IterationReport&)>;

/// How one branch agrees with the image.
struct BranchResidual {
    int branchId = 0;
    int pointCount = 0;
    double medianPx = 0.0;
    double p95Px = 0.0;
    double agreement = 0.0;   ///< share of its points within 3 px of the traced vessels, 0…1
};

/// A branch that the image seems not to show: a proposal to exclude it.
struct UnopacifiedBranch {
    int branchId = 0;
    double share = 0.0;   ///< of its length inside the image that looks empty, 0…1
};

/// Closest-point distances over all used tree points (without those that look empty), and the reverse direction
/// (ALGORITHMS §4.5).
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
    Matrix6d covariance = Matrix6d::Zero();   ///< with what the errors of the camera add
    Matrix6d imageCovariance = Matrix6d::Zero();   ///< without: where the camera is right
    Eigen::Vector3d rotationDeg = Eigen::Vector3d::Zero();   ///< 1-σ about camera x, y, z
    double inPlaneMm = 0.0;   ///< 1-σ, the larger lateral direction
    double depthMm = 0.0;   ///< 1-σ along the ray
    std::array<bool, 6> observed{};   ///< false: the image cannot tell this degree of freedom
    Vector6d weakestDirection = Vector6d::Zero();   ///< unit, same order, in (ρ·rad, mm)
};

/// What images say about the error of a camera (ALGORITHMS §6.18).
struct CameraEvidence {
    CameraError error = CameraError::Zero();   ///< most likely, given how far the camera may be off
    CameraError std = CameraError::Zero();   ///< 1-σ that is left of it
    double gain = 0.0;   ///< how much better all errors explain the images: fall of −2 log of the posterior

    bool operator==(const CameraEvidence&) const = default;
};

/// Wall times of a registration.
struct StageTimes {
    static constexpr double notMeasured = std::numeric_limits<double>::quiet_NaN();

    double targetMs = 0.0;
    double searchMs = 0.0;
    double solveMs = 0.0;
    double totalMs = 0.0;   ///< from curves to the judged pose; reading and tracing come before it
    double readMs = notMeasured;   ///< of the files
    double traceMs = notMeasured;   ///< of the view's vessels in the image
};

/// Another pose that explains the image nearly as well.
struct Hypothesis {
    RigidTransform cameraFromPatient;
    double score = 0.0;   ///< 0…1, higher is better, comparable within one result
};

/// What tells how far a fit may be off, without knowing the truth (ALGORITHMS §6.21).
struct FitSigns {
    double agreement = 0.0;   ///< both ways, 0…1 (§6.8); of the filled parts where only these count
    double treeShare = 0.0;   ///< of the tree's points, that lie along traced vessels
    double inViewShare = 0.0;   ///< of the tree's points
    double followedShare = 0.0;   ///< of the tree's length inside the image, that runs along vessels
    double followedMm = 0.0;   ///< the length of it
    int followedBranches = 0;
    double settlingMm = 0.0;   ///< how far the pose slides when it is refined where it is
    double expectedErrorMm = 0.0;   ///< by the covariance of a rigid tree, 1-σ
    double rivalMm = 0.0;   ///< how far the farthest alternative puts the tree elsewhere
    bool isPartlyOpacified = false;
    int filledForks = 0;   ///< places where three filled pieces or more meet; of a tree filled in parts
    bool isSinglePath = false;   ///< nowhere do three pieces meet that lie on vessels
    bool isLumen = false;   ///< by their widths these are filled vessels, no wire or catheter; false: or not known
};

/// Who had a result found, when, by which program and with what.
struct Provenance {
    std::string author;   ///< empty: not known
    std::string time;   ///< ISO 8601, UTC; empty: not known
    std::string programVersion;   ///< empty: not known
    RegistrationOptions options;
    std::optional<int> frame{};   ///< of the angiogram, counts from 0: what is said of the fit holds for it alone
    std::optional<RigidTransform> start{};   ///< camera from patient, from which it began; none: not known
};

struct RegistrationResult {
    std::string method;
    RigidTransform cameraFromPatient;
    StopReason stopReason = StopReason::IterationLimit;
    int iterations = 0;
    DistanceMetrics metrics;
    PoseUncertainty uncertainty;
    std::optional<CameraEvidence> camera;   ///< none: the camera counts as exact
    std::vector<BranchResidual> branches;   ///< used branches, in the tree's order
    std::vector<UnopacifiedBranch> unopacified;   ///< in the tree's order; the pose rests on the others
    std::vector<Hypothesis> alternatives;   ///< best first, without the result itself
    std::vector<WirePath> wirePaths;   ///< of the method that follows a wire: its own first, then the alternatives
    /// What bending the vessels from this pose found; null: it was not asked. Of views that are
    /// registered together every result has it with its own view as the first (MultiViewResult: once for all).
    std::shared_ptr<const DeformableResult> deformed;
    std::vector<IterationReport> history;   ///< for the convergence plot
    FitSigns signs;
    /// Probability that the overlay lies within 2 mm of the vessels, in the mean over the tree (ALGORITHMS §6.21).
    /// None: of other methods than the default, of several views and of poses set by hand it is not known.
    std::optional<double> probabilityWithin2Mm;
    bool trustworthy = false;
    Messages warnings;   ///< why it is not trustworthy, or what one view cannot tell
    StageTimes time;
    Provenance provenance;   ///< of a result that a case keeps: see registerCase
};

}   // namespace angiopose::core
