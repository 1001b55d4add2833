#pragma once

#include "core/registration/problem/registration_result.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace angiopose::core {

/// Assumptions of the deformable registration (ALGORITHMS §11).
struct DeformableOptions {
    double posePriorDeg = 1.0;   ///< 1-σ per axis of the rotation relative to the rigid pose
    double posePriorMm = 3.0;   ///< 1-σ per axis of the shift relative to the rigid pose
    double startDeg = 8.0;   ///< 1-σ per axis of the initial rotation, as in the covariance of the rigid pose
    double startLateralMm = 30.0;   ///< 1-σ per axis of the initial shift across the ray
    double startDepthMm = 30.0;   ///< 1-σ of the initial shift along the ray
    double geometryDeg = 0.0;   ///< 1-σ per axis of the rotation between views
    double geometryMm = 0.0;   ///< 1-σ per axis of the shift between views
    double knotSpacingMm = 5.0;   ///< spacing of the knots where motion is estimated; it is interpolated in between
    int maxKnots = 450;   ///< upper limit; larger trees get a wider knot spacing
    int randomSeed = 1;   ///< seed of the random starting points of the fits
};

/// One view with the input and the resulting pose of its rigid registration.
struct DeformableView {
    RegistrationInput input;
    RigidTransform rigidCameraFromPatient;
    std::size_t number = 0;   ///< view number shown in messages; 0 stands for the position in the list, starting at 1
};

/// Rigid: no evidence of deformation; the rigid pose is unchanged. Unsure: the vessels are deformed, but fits from
/// different starting points disagree, too little of the tree is visible, or the deformed vessels still do not match.
enum class DeformationVerdict { Rigid, Deformed, Unsure };

/// Nonrigid motion of the points of one branch.
struct BranchMotion {
    int branchId = 0;
    std::vector<Eigen::Vector3d> displacementMm;   ///< one per point of the branch, patient axes
    /// Position covariance of each point, from pose and displacement together, mm² in camera axes of the first view: x
    /// and y in the image plane, z along the ray.
    std::vector<Eigen::Matrix3d> covariance;
    double seenShare = 0.0;   ///< fraction of the branch length that matches a traced vessel in at least one view, 0…1
};

/// Rigid component of a deformation, for reporting only; the rigid pose stays unchanged.
struct RigidOffset {
    Vector6d step = Vector6d::Zero();   ///< step to the pose nearest to the deformed tree, about the centroid; rad, mm
    Matrix6d covariance = Matrix6d::Zero();   ///< covariance of that step
    /// Distance between the points of the rigid tree and the deformed one, in 3-D if several views measure the depth
    /// (geometryMm <= posePriorMm), otherwise in the image plane: overall, and for the branch with the largest mean.
    double meanMm = 0.0;
    double farthestMm = 0.0;
    int farthestBranchId = 0;
    double spreadMm = 0.0;   ///< RMS distance of the tree points from their centroid
};

struct DeformableResult {
    DeformationVerdict verdict = DeformationVerdict::Rigid;
    RigidTransform cameraFromPatient;   ///< pose in the first view: the rigid pose nearest to the deformed tree
    std::vector<RigidTransform> viewPoses;   ///< nearest rigid pose in each view
    std::vector<BranchMotion> branches;   ///< one per branch, in the order of the tree
    double logEvidenceGain = 0.0;   ///< log evidence of the deformed tree over the rigid one
    double largestMotionMm = 0.0;   ///< largest nonrigid motion, in the image plane for one view, otherwise in 3-D
    double meanMotionMm = 0.0;
    double spreadMm = 0.0;   ///< RMS difference between the fits, in the image plane of the first view
    double placeStdMm = 0.0;   ///< RMS over the points of the 1-σ position error in the image plane of the first view
    RigidOffset rigid;
    double explainedShare = 0.0;   ///< fraction of the visible tree length that matches a vessel, 0…1
    double noisePx = 0.0;   ///< estimated tracing noise
    StopReason stopReason = StopReason::Converged;
    int iterations = 0;
    double timeMs = 0.0;
    Messages messages;   ///< describe the relative motion and the reason if the result is unsure
};

/// Deforms the tree from its rigid pose to fit the vessels. Jointly estimates the pose and a Gaussian process of
/// motion, matching vessels along the tree: with one view, motion in the image plane (motion along the ray keeps its
/// prior), with several views, motion in 3-D. Fails only on unusable input. Deterministic; calls `observe` after each
/// step on the calling thread; if it returns Stop, keeps the rigid pose with the verdict Unsure.
Result<DeformableResult> deformVessels(std::span<const DeformableView> views, const DeformableOptions& options = {},
                                       const IterationObserver& observe = {});

/// Returns "rigid", "bent" or "unsure".
std::string_view toText(DeformationVerdict verdict);

}   // namespace angiopose::core
