#pragma once

#include "core/support/message.h"

#include <Eigen/Core>
#include <optional>
#include <string>

namespace angiopose::core {

/// Pin-hole model of the X-ray source and detector (FORMATS §1): `u = fx X/Z + cx`, `v = fy Y/Z + cy`.
/// Pixels: u to the right (column), v down (row), (0, 0) is the centre of the first pixel.
/// Camera frame: mm, Z > 0 from the source to the detector. A standard image (seen from the detector) has fx < 0.
struct ProjectionCamera {
    double fx = 0.0;   ///< px; its sign carries the mirror of the display
    double fy = 0.0;   ///< px
    double cx = 0.0;   ///< px
    double cy = 0.0;   ///< px
    int width = 0;   ///< columns of the image
    int height = 0;   ///< rows of the image

    bool operator==(const ProjectionCamera&) const = default;
};

/// Points nearer to the source plane than this do not project, mm.
inline constexpr double minProjectableDepthMm = 1.0;

/// Pixel of a point in the camera frame (mm); nothing when it lies at or behind the source.
std::optional<Eigen::Vector2d> project(const ProjectionCamera& camera, const Eigen::Vector3d& pointInCamera);

/// d(u, v) / d(X, Y, Z) in px/mm at a point with Z > 0.
Eigen::Matrix<double, 2, 3> projectionJacobian(const ProjectionCamera& camera, const Eigen::Vector3d& pointInCamera);

/// Direction (unit, camera frame) of the ray through a pixel.
Eigen::Vector3d rayThroughPixel(const ProjectionCamera& camera, const Eigen::Vector2d& pixel);

/// Millimetres that one pixel covers at the given depth.
double millimetersPerPixel(const ProjectionCamera& camera, double depthMm);

/// What makes this camera unusable, in words for the user; empty when it is fine.
std::optional<Message> findProblem(const ProjectionCamera& camera);

}   // namespace angiopose::core