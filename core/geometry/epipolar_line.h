#pragma once

#include "core/geometry/posed_camera.h"

#include <optional>

namespace angiopose::core {

/// A straight line segment in an image; pixel coordinates as in ProjectionCamera.
struct ImageSegment {
    Eigen::Vector2d beginPx = Eigen::Vector2d::Zero();
    Eigen::Vector2d endPx = Eigen::Vector2d::Zero();
};

/// Returns the epipolar line of a pixel of `first` in the image of `other` (ALGORITHMS §5.7): the ray from the first
/// source through that pixel, clipped to the part in front of both sources and inside the other image. The line begins
/// at the end nearer to the first source. Returns nullopt if no part is visible or a camera is unusable; a single point
/// if the ray passes through the other source.
std::optional<ImageSegment> epipolarLine(const PosedCamera& first, const Eigen::Vector2d& pixel,
                                         const PosedCamera& other);

}   // namespace angiopose::core
