#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/vessel_tree.h"

#include <vector>

namespace angiopose::core {

/// The evaluated pose and the true pose, both cameraFromPatient.
struct PosePair {
    RigidTransform estimate;
    RigidTransform truth;
};

/// Registered and true positions of the same points, in the same order; camera frame, mm.
struct CorrespondingPoints {
    std::vector<Eigen::Vector3d> found;
    std::vector<Eigen::Vector3d> truth;
};

/// Returns the points of a tree, in the tree's order, under both poses.
CorrespondingPoints correspondingPoints(const VesselTree& tree, const PosePair& poses);

/// Returns the points of a deformed tree under the estimated pose and those of the true tree under the true pose. Both
/// trees must have the same number of points.
CorrespondingPoints correspondingPoints(const VesselTree& found, const VesselTree& truth, const PosePair& poses);

/// Projection distances of one registration with known correspondences, PR_i = ‖π(T p_i) − π(T_gt p_i)‖ (ALGORITHMS
/// §4.5). Pixels are converted to mm at the depth of the centroid under the true pose (§2, decision 11).
struct ProjectionError {
    double meanPx = 0.0, rmsPx = 0.0, medianPx = 0.0, p75Px = 0.0, p95Px = 0.0;
    double meanMm = 0.0, rmsMm = 0.0, medianMm = 0.0, p75Mm = 0.0, p95Mm = 0.0;
};

/// 3-D errors in mm, averaged over the target points x (ALGORITHMS §4.5).
struct TargetError {
    double mtreMm = 0.0;   ///< ‖T x − T_gt x‖
    double mtreInPlaneMm = 0.0;   ///< in-plane component of that distance (camera x and y)
    double mrpdMm = 0.0;   ///< distance of T_gt x to the ray through T x; independent of depth
};

/// Error of the pose. In-plane is parallel to the detector; depth is along camera z, positive if the vessels are too
/// far from the source.
struct PoseError {
    double angleDeg = 0.0;   ///< total rotation angle
    double outOfPlaneDeg = 0.0;   ///< tilt about camera x and y
    double inPlaneDeg = 0.0;   ///< roll about camera z, signed
    double centroidMm = 0.0;   ///< distance between the estimated and the true centroid of the tree
    double centroidInPlaneMm = 0.0;
    double centroidDepthMm = 0.0;   ///< positive if the vessels are too far from the source
    double seedDistanceMm = 0.0;   ///< the seed's "Dist": shift of the source, depends on the frame's origin (§4.3)
};

/// Returns PR_i in px, one per tree point in the order of the tree; infinite if the estimated pose puts a point behind
/// the source. Points that do not project under the true pose have no counterpart and are left out.
std::vector<double> projectionDistancesPx(const VesselTree& tree, const ProjectionCamera& camera,
                                          const PosePair& poses);

std::vector<double> projectionDistancesPx(const ProjectionCamera& camera, const CorrespondingPoints& points);

/// Returns a summary of projectionDistancesPx; all values are NaN if no point projects under the true pose. `depthMm`
/// is the depth at which pixels are converted to mm.
ProjectionError projectionError(const VesselTree& tree, const ProjectionCamera& camera, const PosePair& poses);
ProjectionError projectionError(const ProjectionCamera& camera, const CorrespondingPoints& points, double depthMm);

/// Returns all centerline points and the eight corners of their bounding box, in patient LPS, mm.
std::vector<Eigen::Vector3d> targetsOf(const VesselTree& tree);

TargetError targetError(const std::vector<Eigen::Vector3d>& targetsInPatient, const PosePair& poses);
TargetError targetError(const CorrespondingPoints& targets);

PoseError poseError(const Eigen::Vector3d& centroidInPatient, const PosePair& poses);

/// Returns the error in the convention of PoseUncertainty: rotation (rad) and centroid shift (mm) in camera axes.
Vector6d errorAboutCentroid(const Eigen::Vector3d& centroidInPatient, const PosePair& poses);

/// Returns eᵀΣ⁻¹e, approximately χ² with 6 degrees of freedom if the covariance is realistic.
double normalizedErrorSquared(const Vector6d& error, const Matrix6d& covariance);

}   // namespace angiopose::core
