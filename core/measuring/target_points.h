#pragma once

#include "core/case/case.h"
#include "core/geometry/sight.h"
#include "core/measuring/image_scale.h"
#include "core/vessel/vessel_mark.h"

#include <functional>
#include <optional>
#include <span>

namespace angiopose::core {

/// Error of a target point in an image: projected position against marked position.
struct ImageError {
    Eigen::Vector2d expectedPx = Eigen::Vector2d::Zero();   ///< projected position under the pose
    Eigen::Vector2d seenPx = Eigen::Vector2d::Zero();
    double px = 0.0;   ///< distance between both
    double mm = 0.0;   ///< same in the image plane at the point's depth
    double depthMm = 0.0;   ///< distance of the point from the source
    double mmPerPx = 0.0;   ///< at that depth
};

/// Fails if the point lies behind the source or there is no camera.
Result<ImageError> imageError(const Sight& sight, const Eigen::Vector3d& pointInPatient, const Eigen::Vector2d& seenPx);

/// Returns the covariance (mm², camera axes) of a point at `armInCamera` from the tree's centroid, from the covariance
/// of the pose.
Eigen::Matrix3d placeCovariance(const Matrix6d& poseCovariance, const Eigen::Vector3d& armInCamera);

/// Expected error of a point according to a result: 1-σ, root mean square length in mm.
struct ClaimedError {
    double inPlaneMm = 0.0;   ///< as in ImageError; without camera errors, which move tree and rays alike
    double spaceMm = 0.0;   ///< including camera errors
};
ClaimedError claimedError(const RegistrationResult& result, const VesselTree& tree, const ProjectionCamera& camera,
                          const Eigen::Vector3d& pointInPatient);

/// A point marked in an image.
struct PointedPixel {
    Sight sight;
    Eigen::Vector2d seenPx = Eigen::Vector2d::Zero();
};

/// Best intersection of the rays of two or more images.
struct MeetingPoint {
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< point with the least sum of squared pixel distances
    double angleDeg = 0.0;   ///< largest angle between two rays, at most 90
    double raysApartMm = 0.0;   ///< largest distance of a ray from the point
};

/// Triangulates the point. Fails with a reason if there are fewer than two images or their directions are nearly
/// parallel.
Result<MeetingPoint> meetingPoint(std::span<const PointedPixel> seen);

/// Result for a target point in one view.
struct CheckedView {
    std::size_t view = 0;   ///< index into Case::views
    int frame = 0;   ///< frame in which it was marked
    Result<ImageError> error;   ///< error of the vessels under the rigid pose
    std::optional<double> deformedMm;   ///< same error with the deformed vessels, if a deformation is known
    std::optional<ClaimedError> claimed;   ///< error expected by the result that found the pose
};

/// Results for one target point: its marked positions and the error of the pose at each.
struct CheckedPoint {
    VesselMark mark;
    std::vector<CheckedView> views;   ///< views in which it was marked, in the order of the case
    Result<MeetingPoint> meeting;   ///< from the rays of views whose pose belongs to the marked frame
    std::vector<std::size_t> meetingViews;
    std::optional<double> claimedSpaceMm;   ///< smallest error claimed by a result of these views

    /// Returns the distance from the intersection of the rays; the rays must intersect.
    double spaceMm() const { return (meeting.value().pointInPatient - mark.pointInPatient).norm(); }
};

/// Returns the cameraFromPatient pose of a view by its index.
using PoseOfView = std::function<RigidTransform(std::size_t view)>;

/// Returns the results of all target points of a case, in its order, without ostium rings. `poseOf`: the displayed
/// poses.
std::vector<CheckedPoint> checkedPoints(const Case& session, const PoseOfView& poseOf);
std::vector<CheckedPoint> checkedPoints(const Case& session);   ///< at the case's own poses

/// Returns a short list label: "1.2 mm off, 0.6 mm claimed" for the shown view, or else in space; nothing if neither is
/// known.
std::optional<Message> labelOf(const CheckedPoint& checked, std::size_t shownView);

/// Return messages about the result of one view, and about all views together.
Messages sentencesOf(const CheckedView& checked);
Messages spaceSentences(const CheckedPoint& checked);

}   // namespace angiopose::core
