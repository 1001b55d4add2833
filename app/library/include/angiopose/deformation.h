#pragma once

#include "angiopose/error.h"
#include "angiopose/export.h"
#include "angiopose/geometry.h"
#include "angiopose/vessel_tree.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace angiopose {

/// Rigid: no evidence of deformation; the rigid pose is unchanged. Unsure: deformed, but registrations from different
/// initial poses differ, too little of the tree is visible, or the vessels still do not match.
enum class DeformationVerdict { Rigid, Deformed, Unsure };

/// Returns "rigid", "bent" or "unsure".
ANGIOPOSE_EXPORT std::string toText(DeformationVerdict verdict);

/// Vessels deformed to match the image after rigid registration (option `deformable`). A single view shows only motion
/// in its image plane; along the ray, the vessels keep their shape. `covarianceMm2` holds the remaining uncertainty.
struct DeformedVessels {
    DeformationVerdict verdict = DeformationVerdict::Rigid;
    VesselTree tree;   ///< deformed tree (LPS, mm): the input points in the same order, displaced
    std::vector<Eigen::Vector3d>
        displacementMm;   ///< N; displacement of each point in addition to any rigid motion, along the patient axes
    std::vector<Eigen::Matrix3d>
        covarianceMm2;   ///< N; position covariance of each point along the camera axes of the first view
    std::vector<double> seenShare;   ///< N; fraction of the branch's length that matches a traced vessel, 0…1
    std::vector<Pose> viewPoses;   ///< one per view: the rigid pose closest to `tree`, with which to project it
    double logEvidenceGain = 0.0;   ///< log evidence of the deformed vessels relative to the rigid ones
    double meanMotionMm = 0.0;   ///< mean displacement, in the image plane for a single view, otherwise in 3-D
    double largestMotionMm = 0.0;   ///< largest displacement, in the image plane for a single view, otherwise in 3-D
    double spreadMm = 0.0;   ///< RMS difference between registrations from different initial poses, in the image plane
    double placeStdMm = 0.0;   ///< RMS standard deviation of a point's position in the image plane
    double rigidOffMm = 0.0;   ///< mean residual at the rigid pose
    double rigidOffMostMm = 0.0;   ///< mean residual of the worst branch at the rigid pose
    int rigidOffMostAtBranch = 0;
    double explainedShare = 0.0;   ///< fraction of the visible length of the tree that is explained, 0…1
    double noisePx = 0.0;   ///< estimated noise of the traced vessels
    std::vector<Message> messages;   ///< states what moved relative to what, and why the result may be unsure
};

}   // namespace angiopose
