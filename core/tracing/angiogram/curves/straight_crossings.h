#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Returns whether a path runs straight from one side of the field to another, like leads, wires and bone edges outside
/// the heart: no vessel enters an image, keeps its direction and leaves the image. The path may deviate from a line by
/// 1 % of its length.
bool crossesFieldStraight(const std::vector<Eigen::Vector2d>& pathPx, const Mask2d& field);

}   // namespace angiopose::core
