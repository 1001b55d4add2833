#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Whether a path runs straight from one side of the field to another, as leads, wires and bone edges outside the heart
/// do: no vessel enters an image, keeps its direction and leaves it. A deviation of 1 % of the length is allowed.
bool runsStraightAcross(const std::vector<Eigen::Vector2d>& pathPx, const Mask2d& field);

}   // namespace angiopose::core
