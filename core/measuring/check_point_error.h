#pragma once

#include "core/geometry/sight.h"
#include "core/measuring/image_scale.h"
#include "core/vessel/vessel_mark.h"

#include <optional>
#include <span>

namespace angiopose::core {

/// How far beside the place where it is seen a check point lies in an image.
struct ImageError {
    Eigen::Vector2d expectedPx = Eigen::Vector2d::Zero();   ///< where the pose puts it
    Eigen::Vector2d seenPx = Eigen::Vector2d::Zero();
    double px = 0.0;   ///< between them
    double mm = 0.0;   ///< the same in the plane of the image at the point's depth
    double depthMm = 0.0;   ///< of the point from the source
    double mmPerPx = 0.0;   ///< at that depth
};

/// Fails behind the source and without a camera.
Result<ImageError> imageError(const Sight& sight, const Eigen::Vector3d& pointInPatient, const Eigen::Vector2d& seenPx);

/// Covariance (mm², camera axes) of a place that lies `armInCamera` from the tree's centroid, from that of the pose.
Eigen::Matrix3d placeCovariance(const Matrix6d& poseCovariance, const Eigen::Vector3d& armInCamera);

/// What a result expects of the error of a place: 1-σ, root mean square of its length in mm.
struct ClaimedError {
    double inPlaneMm = 0.0;   ///< as ImageError measures it; the camera counts as right, it moves tree and rays alike
    double spaceMm = 0.0;   ///< with the errors of the camera
};
ClaimedError claimedError(const RegistrationResult& result, const VesselTree& tree, const ProjectionCamera& camera,
                          const Eigen::Vector3d& pointInPatient);

/// A point as it is seen in an image.
struct PointedPixel {
    Sight sight;
    Eigen::Vector2d seenPx = Eigen::Vector2d::Zero();
};

/// Where the rays of two images or more meet best.
struct MeetingPoint {
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< smallest sum of squared pixel distances
    double angleDeg = 0.0;   ///< the widest between two of the rays, up to 90
    double raysApartMm = 0.0;   ///< the farthest of the rays from the point
};

/// Triangulates. Fails, saying why, with fewer than two images, and where they look from nearly the same side.
Result<MeetingPoint> meetingPoint(std::span<const PointedPixel> seen);

}   // namespace angiopose::core
