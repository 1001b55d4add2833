#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>

namespace angiopose::core {

/// Returns whether the edge of the field or image lies within 10 px of a point.
bool isAtFieldEdge(const Eigen::Vector2d& pointPx, const Mask2d& field);

}   // namespace angiopose::core
