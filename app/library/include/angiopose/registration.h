#pragma once

#include "angiopose/angiogram.h"
#include "angiopose/bending.h"
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

/// Everything one registration needs; the first four tell the problem.
struct RegistrationInput {
    VesselTree tree;
    Centerline2d target;
    ProjectionCamera camera;
    Pose initialCameraFromPatient = Pose::Identity();   ///< where the search begins
    std::vector<int> excludedBranchIds;   ///< not used at all
    std::vector<int> auxiliaryBranchIds;   ///< solved by themselves first, by methods that alternate; none: the nodes
    Image image;   ///< the frame that shows the target, for methods that look at it; empty: they draw the target
    Polarity polarity = Polarity::VesselsDark;   ///< of `image`
    std::optional<Volume> volume;   ///< the CTA that shows the tree; not set: radiographs are made of tubes
    std::optional<Pose> lockReference;   ///< what locked angles are counted from; not set: the start
    std::optional<Eigen::Vector3d> lockPivotInPatient;   ///< whose place locked shifts keep; not set: the centroid
};

enum class StopReason { Converged, IterationLimit, NoImprovement, StoppedByUser };

/// In words: "converged", "iteration limit", …
ANGIOPOSE_EXPORT std::string toText(StopReason reason);

/// Closest-point distances over all used tree points, and the reverse direction.
struct DistanceMetrics {
    double meanPx = 0.0, medianPx = 0.0, p75Px = 0.0, p95Px = 0.0;
    double meanMm = 0.0, medianMm = 0.0, p75Mm = 0.0, p95Mm = 0.0;   ///< at the depth of the tree's centroid
    double coverage = 0.0;   ///< share of image points within 3 px of the projected tree, 0…1
    double reverseMeanPx = 0.0, reverseMeanMm = 0.0;
};

/// Covariance of a pose about `centroidInPatient` in camera axes. Order: rotation x, y, z (rad), shift x, y, z (mm).
/// With c = cameraFromPatient · centroid, (r, t) is the error that takes a camera point p to c + R(r) (p − c) + t.
struct PoseUncertainty {
    Eigen::Vector3d centroidInPatient = Eigen::Vector3d::Zero();   ///< LPS mm, of the whole tree by length
    Matrix6d covariance = Matrix6d::Zero();
    Eigen::Vector3d rotationDeg = Eigen::Vector3d::Zero();   ///< 1-σ about camera x, y, z
    double inPlaneMm = 0.0;   ///< 1-σ, the larger lateral direction
    double depthMm = 0.0;   ///< 1-σ along the ray
    std::array<bool, 6> observed{};   ///< false: the image cannot tell this degree of freedom
    Vector6d weakestDirection = Vector6d::Zero();   ///< unit, same order, rotations times the tree's spread in mm
};

/// How one branch agrees with the image.
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

/// One way that a wire or catheter may take through the tree, and the pose that goes with it.
struct WirePath {
    std::vector<int> branchIds;   ///< in the order that the wire takes them; its tip lies in the last
    Eigen::Vector3d tipInPatient = Eigen::Vector3d::Zero();   ///< LPS mm, on the branch's axis
    double probability = 0.0;   ///< 0…1, among all ways looked at and none of them
    double offAxisMm = 0.0;   ///< rms distance of the wire from the vessels' axes, in the image, at their depth
    double followedShare = 0.0;   ///< of the wire's length in the image, 0…1
    Pose cameraFromPatient = Pose::Identity();
};

struct RegistrationResult {
    std::string method;   ///< empty where a pose was only judged
    Pose cameraFromPatient = Pose::Identity();
    StopReason stopReason = StopReason::IterationLimit;   ///< Converged where a pose was only judged
    int iterations = 0;
    DistanceMetrics metrics;
    PoseUncertainty uncertainty;
    std::vector<BranchResidual> branches;   ///< used branches, in the tree's order
    std::vector<Hypothesis> alternatives;   ///< best first, without the result itself
    std::vector<WirePath> wirePaths;   ///< of the method `wire`, most likely first; the pose is that of the first
    std::optional<DeformedVessels>
        deformed;   ///< where bending was asked (option `deformable`); the pose stays the rigid one
    bool trustworthy = false;   ///< false: look before you use the pose; `warnings` say why
    /// That the overlay lies within 2 mm of the vessels, in the mean over the tree; learned from made-up vessels. Known
    /// of what the default method found in one view, else empty.
    std::optional<double> probabilityWithin2Mm;
    std::vector<Message> warnings;
    double totalMs = 0.0;
};

/// Finds the pose that lays the projected tree onto the image points. The same input gives the same bits.
/// Running out of iterations or Stop is a result that keeps the best pose; throws Error on unusable input, naming it.
ANGIOPOSE_EXPORT RegistrationResult registerVessels(const RegistrationInput& input,
                                                    const RegistrationOptions& options = {},
                                                    const Observer& observe = {});

/// Judges a pose without moving it: metrics, residuals of the branches, covariance, warnings.
ANGIOPOSE_EXPORT RegistrationResult evaluatePose(const RegistrationInput& input, const Pose& cameraFromPatient);

/// One tree in several views.
struct MultiViewResult {
    std::vector<RegistrationResult> views;   ///< each judged at its joint pose, in the order given
    std::vector<Vector6d> corrections;   ///< of each view's geometry to the first: turn (rad), shift (mm), camera axes
    PoseUncertainty uncertainty;   ///< of the first view's pose, from all views
    std::optional<DeformedVessels>
        deformed;   ///< from all views, in space; where bending was asked (option `deformable`)
    bool trustworthy = false;
    std::vector<Message> warnings;
};

/// Registers one tree to two or more views of the same moment, which tells the depth. The start poses tell how the
/// cameras stand to each other; each view but the first may leave that by about 0.5° and 1.5 mm (1-σ per axis), as
/// headers are off by as much. `corrections` says by how much it did.
ANGIOPOSE_EXPORT MultiViewResult registerViews(const std::vector<RegistrationInput>& views,
                                               const RegistrationOptions& options = {}, const Observer& observe = {});

/// From .json, or an ITK .tfm, .mat or .h5; the latter map patient points to camera points.
ANGIOPOSE_EXPORT Pose readPose(const std::string& path);

/// To .json, .tfm or .h5, by the extension; every number restores to the last bit.
ANGIOPOSE_EXPORT void writePose(const Pose& cameraFromPatient, const std::string& path);

}   // namespace angiopose
