#pragma once

#include "angiopose/angiogram.h"
#include "angiopose/deformation.h"
#include "angiopose/error.h"
#include "angiopose/export.h"
#include "angiopose/geometry.h"
#include "angiopose/observer.h"
#include "angiopose/options.h"
#include "angiopose/vessel_tree.h"
#include "angiopose/volume.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace angiopose {

/// Input of one registration; the first four members define the problem.
struct RegistrationInput {
    VesselTree tree;
    Centerline2d target;
    ProjectionCamera camera;
    Pose initialCameraFromPatient = Pose::Identity();   ///< initial pose of the search
    std::vector<int> excludedBranchIds;   ///< not used at all
    std::vector<int> auxiliaryBranchIds;   ///< branches of the auxiliary problem, which alternating methods solve
                                           ///< first; empty: the nodes
    Image image;   ///< frame that shows the target, for image-based methods; empty: they render the target
    Polarity polarity = Polarity::VesselsDark;   ///< of `image`
    std::optional<Volume> volume;   ///< CTA that shows the tree; not set: DRRs are computed from tubes
    std::optional<Pose> lockReference;   ///< reference pose of locked angles; not set: the initial pose
    std::optional<Eigen::Vector3d>
        lockPivotInPatient;   ///< point whose position locked shifts preserve; not set: the centroid
};

enum class StopReason { Converged, IterationLimit, NoImprovement, StoppedByUser };

/// Text of a stop reason: "converged", "iteration limit", …
ANGIOPOSE_EXPORT std::string toText(StopReason reason);

/// Closest-point distances over all used tree points, and coverage in the reverse direction.
struct DistanceMetrics {
    double meanPx = 0.0, medianPx = 0.0, p75Px = 0.0, p95Px = 0.0;
    double meanMm = 0.0, medianMm = 0.0, p75Mm = 0.0, p95Mm = 0.0;   ///< at the depth of the tree's centroid
    double coverage = 0.0;   ///< share of image points within 3 px of the projected tree, 0…1
    double reverseMeanPx = 0.0, reverseMeanMm = 0.0;
};

/// Covariance of a pose about `centroidInPatient` in camera axes. Order: rotation x, y, z (rad), shift x, y, z (mm).
/// With c = cameraFromPatient · centroid, (r, t) is the error that takes a camera point p to c + R(r) (p − c) + t.
struct PoseUncertainty {
    Eigen::Vector3d centroidInPatient = Eigen::Vector3d::Zero();   ///< LPS, mm; length-weighted over the whole tree
    Matrix6d covariance = Matrix6d::Zero();
    Eigen::Vector3d rotationDeg = Eigen::Vector3d::Zero();   ///< 1-σ about camera x, y, z
    double inPlaneMm = 0.0;   ///< 1-σ in the larger lateral direction
    double depthMm = 0.0;   ///< 1-σ along the ray
    std::array<bool, 6> observed{};   ///< false: the image does not constrain this degree of freedom
    Vector6d weakestDirection =
        Vector6d::Zero();   ///< unit vector in the same order; rotations are scaled by the tree's spread in mm
};

/// Agreement of one branch with the image.
struct BranchResidual {
    int branchId = 0;
    int pointCount = 0;
    double medianPx = 0.0;
    double p95Px = 0.0;
    double agreement = 0.0;   ///< share of its points within 3 px of the traced vessels, 0…1
};

/// Another pose that explains the image nearly as well.
struct Hypothesis {
    Pose cameraFromPatient = Pose::Identity();
    double score = 0.0;   ///< 0…1, higher is better, comparable within one result
};

/// A possible path of a guidewire or catheter through the tree, with the corresponding pose.
struct WirePath {
    std::vector<int> branchIds;   ///< in the order in which the wire passes them; its tip is in the last one
    Eigen::Vector3d tipInPatient = Eigen::Vector3d::Zero();   ///< LPS mm, on the branch's axis
    double probability = 0.0;   ///< 0…1, over all examined paths and the case that none is right
    double offAxisMm = 0.0;   ///< RMS distance of the wire from the vessel axes in the image, scaled to their depth
    double followedShare = 0.0;   ///< share of the wire's length in the image, 0…1
    Pose cameraFromPatient = Pose::Identity();
};

struct RegistrationResult {
    std::string method;   ///< empty if a pose was only evaluated
    Pose cameraFromPatient = Pose::Identity();
    StopReason stopReason = StopReason::IterationLimit;   ///< Converged if a pose was only evaluated
    int iterations = 0;
    DistanceMetrics metrics;
    PoseUncertainty uncertainty;
    std::vector<BranchResidual> branches;   ///< used branches, in the tree's order
    std::vector<Hypothesis> alternatives;   ///< best first, excluding the result itself
    std::vector<WirePath> wirePaths;   ///< of the method `wire`, most likely first; the pose is that of the first
    std::optional<DeformedVessels>
        deformed;   ///< set if deformation was requested (option `deformable`); the pose is still the rigid one
    bool trustworthy = false;   ///< false: check the overlay before using the pose; `warnings` give the reasons
    /// Calibrated probability that the overlay lies within 2 mm of the vessels on average over the tree; calibrated on
    /// synthetic vessels. Set only for single-view results of the default method.
    std::optional<double> probabilityWithin2Mm;
    std::vector<Message> warnings;
    double totalMs = 0.0;
};

/// Finds the pose that aligns the projected tree with the image points. The same input gives bit-identical results.
/// Reaching the iteration limit or a Stop returns the best pose so far; throws Error on unusable input and names it.
ANGIOPOSE_EXPORT RegistrationResult registerVessels(const RegistrationInput& input,
                                                    const RegistrationOptions& options = {},
                                                    const Observer& observe = {});

/// Evaluates a pose without changing it: metrics, branch residuals, covariance, warnings.
ANGIOPOSE_EXPORT RegistrationResult evaluatePose(const RegistrationInput& input, const Pose& cameraFromPatient);

/// Result of registering one tree to several views.
struct MultiViewResult {
    std::vector<RegistrationResult> views;   ///< each evaluated at its joint pose, in input order
    std::vector<Vector6d> corrections;   ///< correction of each view's geometry relative to the first: rotation (rad),
                                         ///< shift (mm), camera axes
    PoseUncertainty uncertainty;   ///< of the first view's pose, from all views
    std::optional<DeformedVessels>
        deformed;   ///< from all views, in 3-D; set if deformation was requested (option `deformable`)
    bool trustworthy = false;
    std::vector<Message> warnings;
};

/// Registers one tree to two or more views of the same moment, which determines the depth. The initial poses define the
/// relative geometry of the cameras; each view except the first may deviate from it by about 0.5° and 1.5 mm (1-σ per
/// axis), the typical error of headers. `corrections` holds the deviations found.
ANGIOPOSE_EXPORT MultiViewResult registerViews(const std::vector<RegistrationInput>& views,
                                               const RegistrationOptions& options = {}, const Observer& observe = {});

/// Reads a pose from .json or an ITK .tfm, .mat or .h5; the ITK transforms map patient points to camera points.
ANGIOPOSE_EXPORT Pose readPose(const std::string& path);

/// Writes a pose as .json, .tfm or .h5, by the extension; every number is restored to the last bit.
ANGIOPOSE_EXPORT void writePose(const Pose& cameraFromPatient, const std::string& path);

}   // namespace angiopose
