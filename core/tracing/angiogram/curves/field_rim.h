#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>

namespace angiopose::core {

/// Whether the field or the image ends within 10 px of a point.
bool isAtRim(const Eigen::Vector2d& pointPx, const Mask2d& field);

}   // namespace angiopose::core
