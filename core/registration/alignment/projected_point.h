#pragma once

#include "core/geometry/projection_camera.h"
#include "core/registration/pose/centroid_pose.h"

#include <cmath>

namespace angiopose::core {

/// Tree point relative to the tree's centroid, for inner loops.
struct AlignmentPoint {
    Eigen::Vector3d fromCentroid;   ///< mm, patient axes
    Eigen::Vector3d tangent;   ///< unit vector, patient axes
    int branchIndex = 0;
};

/// Tree point in the camera frame and in the image for one pose.
struct PointInCamera {
    Eigen::Vector3d turned;   ///< offset from the centroid, camera axes, mm
    Eigen::Vector3d inCamera;
    double perDepth;   ///< reciprocal of the depth, 1/mm
    double u, v;   ///< pixel position
    double su, sv;   ///< unit direction of the point's branch in the image
    bool isInFront = false;   ///< whether the point is in front of the source; otherwise the other values are undefined
    bool hasDirection = false;   ///< false if the branch runs along the ray at this point
};

/// Minimum projected length of a unit tangent; shorter ones carry no direction (§6.3).
inline constexpr double endOnShare = 0.3;

/// Projects the point at the given pose; returns false if the point is not in front of the source.
inline bool seePlace(const ProjectionCamera& camera, const AlignmentPoint& point, const CentroidPose& pose,
                     PointInCamera& seen)
{
    seen.turned.noalias() = pose.rotation * point.fromCentroid;
    seen.inCamera = seen.turned + pose.centroidInCamera;
    seen.perDepth = 1.0 / seen.inCamera.z();
    seen.u = camera.fx * seen.inCamera.x() * seen.perDepth + camera.cx;
    seen.v = camera.fy * seen.inCamera.y() * seen.perDepth + camera.cy;
    return seen.inCamera.z() >= minProjectableDepthMm;
}

/// Computes the projected direction of the branch; call after seePlace.
inline void seeDirection(const ProjectionCamera& camera, const AlignmentPoint& point, const CentroidPose& pose,
                         PointInCamera& seen)
{
    const Eigen::Vector3d tangent = pose.rotation * point.tangent;
    const double su = camera.fx * (tangent.x() - seen.inCamera.x() * seen.perDepth * tangent.z());
    const double sv = camera.fy * (tangent.y() - seen.inCamera.y() * seen.perDepth * tangent.z());
    const double length = std::sqrt(su * su + sv * sv);
    const double perLength = length > 0.0 ? 1.0 / length : 0.0;
    seen.su = su * perLength;
    seen.sv = sv * perLength;
    seen.hasDirection = length >= endOnShare * camera.fy;
}

/// Returns d(distance along the normal) / d(rotation rad, shift mm).
inline Vector6d distanceGradient(const ProjectionCamera& camera, const PointInCamera& seen, double normalX,
                                 double normalY)
{
    const double ax = normalX * camera.fx * seen.perDepth;
    const double ay = normalY * camera.fy * seen.perDepth;
    const Eigen::Vector3d a(ax, ay, -(ax * seen.inCamera.x() + ay * seen.inCamera.y()) * seen.perDepth);
    Vector6d J;
    J << seen.turned.cross(a), a;
    return J;
}

}   // namespace angiopose::core
