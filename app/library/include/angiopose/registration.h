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
    std::vector<int> excludedBranchIds;   ///< branches not used in registration
    std::vector<int> auxiliaryBranchIds;   ///< branches of the auxiliary problem, which alternating methods solve
                                           ///< first; if empty, the nodes of the tree
    Image image;   ///< frame that shows the target, for image-based methods; if empty, they render the target
    Polarity polarity = Polarity::VesselsDark;   ///< polarity of `image`
    std::optional<Volume> volume;   ///< CTA that contains the tree; if not set, the DRRs show tubes
    std::optional<Pose> lockReference;   ///< reference pose for locked angles; if not set, the initial pose
    std::optional<Eigen::Vector3d>
        lockPivotInPatient;   ///< point held fixed by locked translations; if not set, the centroid
};

enum class StopReason { Converged, IterationLimit, NoImprovement, StoppedByUser };

/// Returns the name of a stop reason: "converged", "iteration limit", …
ANGIOPOSE_EXPORT std::string toText(StopReason reason);

/// Closest-point distances of all tree points used, with the coverage and distances in the reverse direction.
struct DistanceMetrics {
    double meanPx = 0.0, medianPx = 0.0, p75Px = 0.0, p95Px = 0.0;
    double meanMm = 0.0, medianMm = 0.0, p75Mm = 0.0, p95Mm = 0.0;   ///< distances at the depth of the tree's centroid
    double coverage = 0.0;   ///< fraction of image points within 3 px of the projected tree, 0…1
    double reverseMeanPx = 0.0, reverseMeanMm = 0.0;
};

/// Covariance of a pose about `centroidInPatient` in camera axes. Order: rotation x, y, z (rad), shift x, y, z (mm).
/// With c = cameraFromPatient · centroid, the error (r, t) maps a camera point p to c + R(r) (p − c) + t.
struct PoseUncertainty {
    Eigen::Vector3d centroidInPatient = Eigen::Vector3d::Zero();   ///< centroid of the tree, length-weighted; LPS, mm
    Matrix6d covariance = Matrix6d::Zero();
    Eigen::Vector3d rotationDeg = Eigen::Vector3d::Zero();   ///< standard deviations about camera x, y, z
    double inPlaneMm = 0.0;   ///< standard deviation in the less certain in-plane direction
    double depthMm = 0.0;   ///< standard deviation along the ray
    std::array<bool, 6> observed{};   ///< false if the image does not constrain this degree of freedom
    Vector6d weakestDirection =
        Vector6d::Zero();   ///< unit vector in the same order; rotations are scaled by the tree's spread in mm
};

/// Agreement of one branch with the image.
struct BranchResidual {
    int branchId = 0;
    int pointCount = 0;
    double medianPx = 0.0;
    double p95Px = 0.0;
    double agreement = 0.0;   ///< fraction of its points within 3 px of the traced vessels, 0…1
};

/// Alternative pose that explains the image nearly as well.
struct Hypothesis {
    Pose cameraFromPatient = Pose::Identity();
    double score = 0.0;   ///< 0…1, higher is better; comparable only within one result
};

/// Possible path of a guidewire or catheter through the tree, with the pose that results from it.
struct WirePath {
    std::vector<int> branchIds;   ///< in the order in which the wire passes through them; the tip is in the last branch
    Eigen::Vector3d tipInPatient = Eigen::Vector3d::Zero();   ///< tip of the wire, on the branch centerline; LPS, mm
    double probability = 0.0;   ///< 0…1, normalized over all examined paths and the case that none is correct
    double offAxisMm = 0.0;   ///< RMS distance of the wire from the centerlines in the image, scaled to their depth
    double followedShare = 0.0;   ///< fraction of the wire's length in the image that the path explains, 0…1
    Pose cameraFromPatient = Pose::Identity();
};

struct RegistrationResult {
    std::string method;   ///< empty if the pose was only evaluated
    Pose cameraFromPatient = Pose::Identity();
    StopReason stopReason = StopReason::IterationLimit;   ///< `Converged` if the pose was only evaluated
    int iterations = 0;
    DistanceMetrics metrics;
    PoseUncertainty uncertainty;
    std::vector<BranchResidual> branches;   ///< branches used, in the order of the tree
    std::vector<Hypothesis> alternatives;   ///< from best to worst; the result itself is not included
    std::vector<WirePath> wirePaths;   ///< of the method `wire`, most likely first; the pose is that of the first
    std::optional<DeformedVessels>
        deformed;   ///< set if deformation was requested (option `deformable`); the pose itself remains rigid
    bool trustworthy = false;   ///< if false, check the overlay before using the pose; `warnings` give the reasons
    /// Calibrated probability that the overlay lies within 2 mm of the vessels on average over the tree. The
    /// calibration used synthetic vessels. Set only for single-view results of the default method.
    std::optional<double> probabilityWithin2Mm;
    std::vector<Message> warnings;
    double totalMs = 0.0;
};

/// Finds the pose that aligns the projected tree with the image points. The same input gives bit-identical results.
/// Returns the best pose so far at the iteration limit or on Stop; throws an Error that names any unusable input.
ANGIOPOSE_EXPORT RegistrationResult registerVessels(const RegistrationInput& input,
                                                    const RegistrationOptions& options = {},
                                                    const Observer& observe = {});

/// Evaluates a pose without changing it; returns metrics, branch residuals, covariance and warnings.
ANGIOPOSE_EXPORT RegistrationResult evaluatePose(const RegistrationInput& input, const Pose& cameraFromPatient);

/// Result of registering one tree to several views.
struct MultiViewResult {
    std::vector<RegistrationResult> views;   ///< results, each evaluated at its joint pose, in input order
    std::vector<Vector6d> corrections;   ///< correction of the geometry of each view relative to the first view:
                                         ///< rotation (rad), shift (mm), camera axes
    PoseUncertainty uncertainty;   ///< uncertainty of the first view's pose, given all views
    std::optional<DeformedVessels>
        deformed;   ///< 3-D deformation from all views; set if deformation was requested (option `deformable`)
    bool trustworthy = false;
    std::vector<Message> warnings;
};

/// Registers one tree to two or more views acquired at the same moment, which determines the depth. The initial poses
/// define the relative geometry of the cameras, from which each view except the first may deviate by about 0.5° and 1.5
/// mm (1 σ per axis), the typical error of headers. `corrections` contains the estimated deviations.
ANGIOPOSE_EXPORT MultiViewResult registerViews(const std::vector<RegistrationInput>& views,
                                               const RegistrationOptions& options = {}, const Observer& observe = {});

/// Reads a pose from a .json file or an ITK transform (.tfm, .mat or .h5), which maps patient points to camera points.
ANGIOPOSE_EXPORT Pose readPose(const std::string& path);

/// Writes a pose as .json, .tfm or .h5, depending on the extension; all numbers are preserved exactly.
ANGIOPOSE_EXPORT void writePose(const Pose& cameraFromPatient, const std::string& path);

}   // namespace angiopose
