#pragma once

#include "core/vessel/centerline2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Curves of image points in no order (px), such as the pixels of a skeleton: neighbours are joined by a minimum
/// spanning tree, which is cut where it forks. Each point is in one curve; one without neighbours is a curve by itself.
/// Points are neighbours up to 2.5 times their usual distance, and next to each other on the pixel grid.
Centerline2d chainPoints(const std::vector<Eigen::Vector2d>& points);

}   // namespace angiopose::core
