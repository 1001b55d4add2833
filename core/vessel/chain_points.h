#pragma once

#include "core/vessel/centerline2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Chains unordered image points (px), such as skeleton pixels, into curves: neighbors are connected by a minimum
/// spanning tree, which is split at bifurcations. Each point belongs to one curve; a point without neighbors forms its
/// own curve. Neighbors are points within 2.5 times the typical spacing, and adjacent pixels.
Centerline2d chainPoints(const std::vector<Eigen::Vector2d>& points);

}   // namespace angiopose::core
