#pragma once

#include "core/geometry/projection_camera.h"
#include "core/registration/pose/centroid_pose.h"

#include <cmath>

namespace angiopose::core {

/// Tree point relative to the tree's centroid, for use in inner loops.
struct AlignmentPoint {
    Eigen::Vector3d fromCentroid;   ///< mm, patient axes
    Eigen::Vector3d tangent;   ///< unit vector, patient axes
    int branchIndex = 0;
};

/// Tree point in the camera frame and in the image at one pose.
struct PointInCamera {
    Eigen::Vector3d rotated;   ///< offset from the centroid, camera axes, mm
    Eigen::Vector3d inCamera;
    double inverseDepth;   ///< reciprocal of the depth, 1/mm
    double u, v;   ///< pixel position
    double su, sv;   ///< unit direction of the point's branch in the image
    bool isInFront = false;   ///< whether the point is in front of the source; otherwise the other values are undefined
    bool hasDirection = false;   ///< false if the branch runs along the ray at this point
};

/// Minimum projected length of a unit tangent; shorter ones carry no direction (§6.3).
inline constexpr double minDirectionFraction = 0.3;

/// Projects the point at the given pose; returns false if the point is not in front of the source.
inline bool projectPoint(const ProjectionCamera& camera, const AlignmentPoint& point, const CentroidPose& pose,
                         PointInCamera& projected)
{
    projected.rotated.noalias() = pose.rotation * point.fromCentroid;
    projected.inCamera = projected.rotated + pose.centroidInCamera;
    projected.inverseDepth = 1.0 / projected.inCamera.z();
    projected.u = camera.fx * projected.inCamera.x() * projected.inverseDepth + camera.cx;
    projected.v = camera.fy * projected.inCamera.y() * projected.inverseDepth + camera.cy;
    return projected.inCamera.z() >= minProjectableDepthMm;
}

/// Computes the projected direction of the branch; call after projectPoint.
inline void projectDirection(const ProjectionCamera& camera, const AlignmentPoint& point, const CentroidPose& pose,
                             PointInCamera& projected)
{
    const Eigen::Vector3d tangent = pose.rotation * point.tangent;
    const double su = camera.fx * (tangent.x() - projected.inCamera.x() * projected.inverseDepth * tangent.z());
    const double sv = camera.fy * (tangent.y() - projected.inCamera.y() * projected.inverseDepth * tangent.z());
    const double length = std::sqrt(su * su + sv * sv);
    const double perLength = length > 0.0 ? 1.0 / length : 0.0;
    projected.su = su * perLength;
    projected.sv = sv * perLength;
    projected.hasDirection = length >= minDirectionFraction * camera.fy;
}

/// Returns d(distance along the normal) / d(rotation rad, shift mm).
inline Vector6d distanceGradient(const ProjectionCamera& camera, const PointInCamera& projected, double normalX,
                                 double normalY)
{
    const double ax = normalX * camera.fx * projected.inverseDepth;
    const double ay = normalY * camera.fy * projected.inverseDepth;
    const Eigen::Vector3d a(ax, ay,
                            -(ax * projected.inCamera.x() + ay * projected.inCamera.y()) * projected.inverseDepth);
    Vector6d J;
    J << projected.rotated.cross(a), a;
    return J;
}

}   // namespace angiopose::core
