#pragma once

#include "core/registration/problem/registration_result.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace angiopose::core {

/// What is assumed of vessels that may be bent (ALGORITHMS §11).
struct DeformableOptions {
    double posePriorDeg = 1.0;   ///< 1-σ per axis of the pose about the rigid one
    double posePriorMm = 3.0;   ///< likewise of its shift
    double startDeg = 8.0;   ///< 1-σ per axis of the start pose, by which the rigid pose's covariance goes
    double startLateralMm = 30.0;   ///< likewise of its shift across the ray
    double startDepthMm = 30.0;   ///< likewise along the ray
    double geometryDeg = 0.0;   ///< 1-σ per axis of the geometry from view to view
    double geometryMm = 0.0;   ///< likewise of its shift
    double knotSpacingMm = 5.0;   ///< of the places whose motion is found; between them it is interpolated
    int maxKnots = 450;   ///< larger trees get fewer knots per length
    int randomSeed = 1;   ///< of what the runs start from
};

/// One view: everything about it as for a rigid registration, and the pose which that found.
struct DeformableView {
    RegistrationInput input;
    RigidTransform rigidCameraFromPatient;
    std::size_t number = 0;   ///< by which messages name it; 0: its place, from 1
};

/// Rigid: nothing speaks for a bend, the rigid pose stays as it is. Unsure: bent, but runs from different starts
/// differ, too little of the tree is seen, or the vessels still lie beside it.
enum class DeformationVerdict { Rigid, Deformed, Unsure };

/// How the points of one branch moved beyond any rigid motion.
struct BranchMotion {
    int branchId = 0;
    std::vector<Eigen::Vector3d> displacementMm;   ///< one per point of the branch, patient axes
    /// Of each point's place after pose and displacement, mm² in camera axes of the first view: x and y in the image
    /// plane, z along the ray.
    std::vector<Eigen::Matrix3d> covariance;
    double seenShare = 0.0;   ///< of its length that found a traced vessel in some view, 0…1
};

/// What a bend means for the rigid pose, which stays where it is.
struct RigidOffset {
    Vector6d step = Vector6d::Zero();   ///< to the pose nearest to the bent tree, about the centroid; rad, mm
    Matrix6d covariance = Matrix6d::Zero();   ///< of that step
    /// How far the tree's points lie from the bent ones, in the image plane of one view, else in space: in the mean,
    /// and in the mean over the branch where it is most.
    double meanMm = 0.0;
    double farthestMm = 0.0;
    int farthestBranchId = 0;
    double spreadMm = 0.0;   ///< rms distance of the tree from its centroid
};

struct DeformableResult {
    DeformationVerdict verdict = DeformationVerdict::Rigid;
    RigidTransform cameraFromPatient;   ///< of the first view: the rigid pose nearest to the bent tree
    std::vector<RigidTransform> viewPoses;   ///< likewise of each view
    std::vector<BranchMotion> branches;   ///< all branches of the tree, in its order
    double logEvidenceGain = 0.0;   ///< of a bent tree over a rigid one
    double largestMotionMm = 0.0;   ///< in the image plane of the first view, of one view; else in space
    double meanMotionMm = 0.0;
    double spreadMm = 0.0;   ///< rms difference between the runs, in the image plane of the first view
    double placeStdMm = 0.0;   ///< rms 1-σ of a point's place in the image plane of the first view
    RigidOffset rigid;
    double explainedShare = 0.0;   ///< of the visible tree's length, 0…1
    double noisePx = 0.0;   ///< learned, of a traced vessel
    StopReason stopReason = StopReason::Converged;
    int iterations = 0;
    double timeMs = 0.0;
    Messages messages;   ///< what moved against what, in words; why it is unsure
};

/// Bends the tree from its rigid pose onto the vessels: pose and a Gaussian process of motion together, matched along
/// the tree, in one view (motion in the image plane; along the ray it keeps its prior) or several (in space).
/// Fails only on unusable input. Deterministic; `observe` runs on the calling thread after each step, and its Stop
/// leaves the rigid pose with the verdict Unsure.
Result<DeformableResult> deformVessels(std::span<const DeformableView> views, const DeformableOptions& options = {},
                                       const IterationObserver& observe = {});

/// "rigid", "bent", "unsure".
std::string_view toText(DeformationVerdict verdict);

}   // namespace angiopose::core
