#pragma once

#include "core/case/case.h"
#include "core/geometry/posed_camera.h"
#include "core/measuring/image_scale.h"
#include "core/vessel/vessel_mark.h"

#include <functional>
#include <optional>
#include <span>

namespace angiopose::core {

/// Error of a target point in an image: the projected position compared with the marked position.
struct ImageError {
    Eigen::Vector2d projectedPx = Eigen::Vector2d::Zero();   ///< projected position under the pose
    Eigen::Vector2d markedPx = Eigen::Vector2d::Zero();
    double px = 0.0;   ///< distance between the two positions
    double mm = 0.0;   ///< the same distance in the plane parallel to the detector at the point's depth
    double depthMm = 0.0;   ///< distance of the point from the source
    double mmPerPx = 0.0;   ///< pixel size at this depth
};

/// Computes the error. Fails if the point lies behind the source or the camera is invalid.
Result<ImageError> imageError(const PosedCamera& posedCamera, const Eigen::Vector3d& pointInPatient,
                              const Eigen::Vector2d& markedPx);

/// Computes the covariance (mm², camera axes) of a point at offset `leverArmInCamera` from the tree's centroid, given
/// the covariance of the pose.
Eigen::Matrix3d pointCovariance(const Matrix6d& poseCovariance, const Eigen::Vector3d& leverArmInCamera);

/// Expected error of a point according to a registration result: root mean square length in mm, 1 σ.
struct PredictedError {
    double inPlaneMm = 0.0;   ///< as in ImageError; excludes camera errors, which move tree and rays alike
    double spaceMm = 0.0;   ///< in 3-D, including camera errors
};
PredictedError predictError(const RegistrationResult& result, const VesselTree& tree, const ProjectionCamera& camera,
                            const Eigen::Vector3d& pointInPatient);

/// A point marked in an image.
struct MarkedPixel {
    PosedCamera posedCamera;
    Eigen::Vector2d markedPx = Eigen::Vector2d::Zero();
};

/// Best intersection of the rays from two or more images.
struct TriangulatedPoint {
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();   ///< point with the least sum of squared pixel distances
    double angleDeg = 0.0;   ///< largest angle between two rays, 0…90
    double maxRayDistanceMm = 0.0;   ///< largest distance from a ray to the point
};

/// Triangulates a point from its pixels. Fails if there are fewer than two images or if the rays are nearly parallel.
Result<TriangulatedPoint> triangulate(std::span<const MarkedPixel> seen);

/// Result for a target point in one view.
struct TargetPointViewResult {
    std::size_t view = 0;   ///< index into Case::views
    int frame = 0;   ///< frame in which the point was marked
    Result<ImageError> error;   ///< error of the projected point under the rigid pose
    std::optional<double> deformedMm;   ///< the same error with deformed vessels, if a deformation is known
    std::optional<PredictedError> predicted;   ///< expected error according to the registration result of this pose
};

/// Results for one target point: the marked positions and the error of the pose at each of them.
struct TargetPointResult {
    VesselMark mark;
    std::vector<TargetPointViewResult> views;   ///< views in which the point was marked, in the order of the case
    Result<TriangulatedPoint> triangulated;   ///< triangulated from the views whose pose belongs to the marked frame
    std::vector<std::size_t> triangulationViews;
    std::optional<double> predictedSpaceMm;   ///< smallest 3-D error predicted by the results of these views

    /// Returns the distance of the target point from the intersection of the rays; requires a valid intersection.
    double spaceMm() const { return (triangulated.value().pointInPatient - mark.pointInPatient).norm(); }
};

/// Returns the cameraFromPatient pose of a view by its index.
using PoseOfView = std::function<RigidTransform(std::size_t view)>;

/// Returns the results for all target points of a case in the case's order, excluding ostium rings. `poseOf` returns
/// the displayed poses.
std::vector<TargetPointResult> evaluateTargetPoints(const Case& session, const PoseOfView& poseOf);
std::vector<TargetPointResult> evaluateTargetPoints(const Case& session);   ///< uses the poses stored in the case

/// Returns a short list label, such as "1.2 mm off, 0.6 mm predicted", for the shown view or else for the 3-D error;
/// nullopt if neither is known.
std::optional<Message> labelOf(const TargetPointResult& evaluation, std::size_t shownView);

/// Returns messages about the result of one view, or about all views together.
Messages sentencesOf(const TargetPointViewResult& evaluation);
Messages spaceErrorMessages(const TargetPointResult& evaluation);

}   // namespace angiopose::core
