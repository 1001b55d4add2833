#pragma once

#include "angiopose/error.h"
#include "angiopose/export.h"
#include "angiopose/geometry.h"
#include "angiopose/vessel_tree.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace angiopose {

/// Rigid: nothing speaks for a bend, the rigid pose stays as it is. Unsure: bent, but runs from different starts
/// differ, too little of the tree is seen, or the vessels still lie beside it.
enum class DeformationVerdict { Rigid, Deformed, Unsure };

/// "rigid", "bent", "unsure".
ANGIOPOSE_EXPORT std::string toText(DeformationVerdict verdict);

/// Vessels bent onto the image after their rigid registration (option `deformable`). One view tells motion in its image
/// plane; along the ray the vessels keep their shape, and `covarianceMm2` says how little is known there.
struct DeformedVessels {
    DeformationVerdict verdict = DeformationVerdict::Rigid;
    VesselTree tree;   ///< as it was in the image, patient LPS: the points of the input, in its order, each moved
    std::vector<Eigen::Vector3d>
        displacementMm;   ///< N, how far each point moved beyond any rigid motion, patient axes
    std::vector<Eigen::Matrix3d> covarianceMm2;   ///< N, of each point's place; camera axes of the first view
    std::vector<double> seenShare;   ///< N, of the point's branch: share of its length that found a vessel, 0…1
    std::vector<Pose> viewPoses;   ///< of each view: the rigid pose nearest to `tree`, which it is projected with
    double logEvidenceGain = 0.0;   ///< of bent vessels over rigid ones
    double meanMotionMm = 0.0;   ///< in the image plane of one view, else in space
    double largestMotionMm = 0.0;   ///< likewise
    double spreadMm = 0.0;   ///< rms difference between runs from different starts, in the image plane
    double placeStdMm = 0.0;   ///< rms 1-σ of a point's place in the image plane
    double rigidOffMm = 0.0;   ///< how far the rigid pose lies off, in the mean
    double rigidOffMostMm = 0.0;   ///< … and in the mean over the branch where it is most
    int rigidOffMostAtBranch = 0;
    double explainedShare = 0.0;   ///< of the visible tree's length, 0…1
    double noisePx = 0.0;   ///< learned, of a traced vessel
    std::vector<Message> messages;   ///< what moved against what, in words; why it is unsure
};

}   // namespace angiopose
