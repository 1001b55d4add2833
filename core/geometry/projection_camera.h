#pragma once

#include "core/support/message.h"

#include <Eigen/Core>
#include <optional>
#include <string>

namespace angiopose::core {

/// Pinhole model of the X-ray source and detector (FORMATS §1): `u = fx X/Z + cx`, `v = fy Y/Z + cy`. Pixel
/// coordinates: u to the right (column), v down (row); (0, 0) is the center of the first pixel. Camera frame: mm, Z > 0
/// from the source to the detector. In a standard image (seen from the detector), fx is negative.
struct ProjectionCamera {
    double fx = 0.0;   ///< focal length, px; negative unless the display is mirrored
    double fy = 0.0;   ///< focal length, px
    double cx = 0.0;   ///< principal point, px
    double cy = 0.0;   ///< principal point, px
    int width = 0;   ///< columns of the image
    int height = 0;   ///< rows of the image

    bool operator==(const ProjectionCamera&) const = default;
};

/// Minimum distance from the source along the camera axis, mm; nearer points do not project.
inline constexpr double minProjectableDepthMm = 1.0;

/// Returns the pixel of a point in the camera frame (mm); nullopt if the point lies at or behind the source.
std::optional<Eigen::Vector2d> project(const ProjectionCamera& camera, const Eigen::Vector3d& pointInCamera);

/// Returns d(u, v) / d(X, Y, Z) in px/mm at a point with Z > 0.
Eigen::Matrix<double, 2, 3> projectionJacobian(const ProjectionCamera& camera, const Eigen::Vector3d& pointInCamera);

/// Returns the direction (unit vector, camera frame) of the ray through a pixel.
Eigen::Vector3d rayThroughPixel(const ProjectionCamera& camera, const Eigen::Vector2d& pixel);

/// Returns the size of a pixel at the given depth, mm.
double millimetersPerPixel(const ProjectionCamera& camera, double depthMm);

/// Returns a message about why a camera is unusable; nullopt if it is valid.
std::optional<Message> findProblem(const ProjectionCamera& camera);

}   // namespace angiopose::core
