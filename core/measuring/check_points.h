#pragma once

#include "core/case/case.h"
#include "core/geometry/sight.h"
#include "core/measuring/image_scale.h"
#include "core/vessel/vessel_mark.h"

#include <functional>
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

/// What one view tells of a check point.
struct CheckedView {
    std::size_t view = 0;   ///< place in Case::views
    int frame = 0;   ///< in which it was pointed at
    Result<ImageError> error;   ///< of the vessels as the rigid pose has them
    std::optional<double> deformedMm;   ///< the same error with the vessels bent, where that is known
    std::optional<ClaimedError> claimed;   ///< by the result that found the pose
};

/// What is known of one check point: where it was seen, and how far the pose lies beside that.
struct CheckedPoint {
    VesselMark mark;
    std::vector<CheckedView> views;   ///< in which it was pointed at, in the order of the case
    Result<MeetingPoint> meeting;   ///< of the rays of views whose pose is of the frame it was seen in
    std::vector<std::size_t> meetingViews;
    std::optional<double> claimedSpaceMm;   ///< the least that a result of these views claims

    /// From where the rays meet; of nothing where they do not.
    double spaceMm() const { return (meeting.value().pointInPatient - mark.pointInPatient).norm(); }
};

/// Camera from patient of a view by its place.
using PoseOfView = std::function<RigidTransform(std::size_t view)>;

/// Every check point of a case, in its order; rings are none. `poseOf`: as shown.
std::vector<CheckedPoint> checkedPoints(const Case& session, const PoseOfView& poseOf);
std::vector<CheckedPoint> checkedPoints(const Case& session);   ///< at the case's own poses

/// Short, for a list: "1.2 mm off, 0.6 mm claimed" of the shown view, else in space; nothing where neither is known.
std::optional<Message> labelOf(const CheckedPoint& checked, std::size_t shownView);

/// Sentences on what one view tells, and on what all views together tell.
Messages sentencesOf(const CheckedView& checked);
Messages spaceSentences(const CheckedPoint& checked);

}   // namespace angiopose::core
