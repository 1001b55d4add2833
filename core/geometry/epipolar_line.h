#pragma once

#include "core/geometry/sight.h"

#include <optional>

namespace angiopose::core {

/// A straight piece of an image; pixels as of ProjectionCamera.
struct ImageSegment {
    Eigen::Vector2d beginPx = Eigen::Vector2d::Zero();
    Eigen::Vector2d endPx = Eigen::Vector2d::Zero();
};

/// Where in the image of `other` all that lies behind one pixel of `first` may be (ALGORITHMS §5.7): the ray from the
/// first source through that pixel, as far as it lies in front of both sources and inside the other image. It begins on
/// the side of the first source. Nothing where none of it is seen, or a camera is unusable; a point where the ray runs
/// into the other source.
std::optional<ImageSegment> epipolarLine(const Sight& first, const Eigen::Vector2d& pixel, const Sight& other);

}   // namespace angiopose::core
