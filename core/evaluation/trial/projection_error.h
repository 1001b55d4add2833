#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/vessel/vessel_tree.h"

#include <vector>

namespace angiopose::core {

/// A pose to be judged and the true one, both cameraFromPatient.
struct PosePair {
    RigidTransform estimate;
    RigidTransform truth;
};

/// Points where a registration puts them and where they truly lie, one for one, camera frame, mm.
struct PlacedPoints {
    std::vector<Eigen::Vector3d> found;
    std::vector<Eigen::Vector3d> truth;
};

/// The points of a tree in its order: as both poses put them.
PlacedPoints placed(const VesselTree& tree, const PosePair& poses);

/// A bent tree under the pose that was found, and another of as many points under the true one: of vessels that are no
/// rigid body.
PlacedPoints placed(const VesselTree& found, const VesselTree& truth, const PosePair& poses);

/// Projection distances of one registration with known partners, PR_i = ‖π(T p_i) − π(T_gt p_i)‖ (ALGORITHMS §4.5).
/// mm: at the depth of the projected centroid under the true pose (§2, decision 11).
struct ProjectionError {
    double meanPx = 0.0, rmsPx = 0.0, medianPx = 0.0, p75Px = 0.0, p95Px = 0.0;
    double meanMm = 0.0, rmsMm = 0.0, medianMm = 0.0, p75Mm = 0.0, p95Mm = 0.0;
};

/// 3-D errors, means over targets, mm (ALGORITHMS §4.5).
struct TargetError {
    double mtreMm = 0.0;   ///< ‖T x − T_gt x‖
    double mtreInPlaneMm = 0.0;   ///< its part across the ray axis, camera x and y
    double mrpdMm = 0.0;   ///< distance of T_gt x to the ray through T x: blind to depth
};

/// Error of the pose itself. In plane: parallel to the detector; depth: along camera z, + too far from the source.
struct PoseError {
    double angleDeg = 0.0;   ///< total
    double outOfPlaneDeg = 0.0;   ///< tilt about camera x and y
    double inPlaneDeg = 0.0;   ///< roll about camera z, signed
    double centroidMm = 0.0;   ///< distance between the tree's centroids
    double centroidInPlaneMm = 0.0;
    double centroidDepthMm = 0.0;   ///< signed
    double seedDistanceMm = 0.0;   ///< the seed's "Dist": shift of the source, depends on the frame's origin (§4.3)
};

/// PR_i in px, one per tree point in the tree's order. Infinite where the estimate puts a point behind the source;
/// points that do not project under the true pose have no partner and are left out.
std::vector<double> projectionDistancesPx(const VesselTree& tree, const ProjectionCamera& camera,
                                          const PosePair& poses);

std::vector<double> projectionDistancesPx(const ProjectionCamera& camera, const PlacedPoints& points);

/// Summary of projectionDistancesPx; all NaN when no point projects under the true pose. `depthMm`: where pixels are
/// turned into mm.
ProjectionError projectionError(const VesselTree& tree, const ProjectionCamera& camera, const PosePair& poses);
ProjectionError projectionError(const ProjectionCamera& camera, const PlacedPoints& points, double depthMm);

/// All centreline points and the eight corners of their box, patient LPS mm.
std::vector<Eigen::Vector3d> targetsOf(const VesselTree& tree);

TargetError targetError(const std::vector<Eigen::Vector3d>& targetsInPatient, const PosePair& poses);
TargetError targetError(const PlacedPoints& targets);

PoseError poseError(const Eigen::Vector3d& centroidInPatient, const PosePair& poses);

/// Error in the convention of PoseUncertainty: rotation (rad) and centroid shift (mm) in camera axes.
Vector6d errorAboutCentroid(const Eigen::Vector3d& centroidInPatient, const PosePair& poses);

/// eᵀΣ⁻¹e, about χ² with 6 degrees of freedom when the covariance is honest.
double normalizedErrorSquared(const Vector6d& error, const Matrix6d& covariance);

}   // namespace angiopose::core