#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>

namespace angiopose::core {

/// Whether the field ends within 10 px of a point, or the image does.
bool isAtRim(const Eigen::Vector2d& pointPx, const Mask2d& field);

}   // namespace angiopose::core
