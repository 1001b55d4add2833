#pragma once

#include "core/vessel/centerline2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Chains unordered image points (px), such as skeleton pixels, into curves: neighbors are connected by a minimum
/// spanning tree, which is split at bifurcations. Each point belongs to one curve; a point without neighbors forms its
/// own curve. Points are neighbors if they are adjacent pixels or closer than 2.5 times the typical spacing.
Centerline2d chainPoints(const std::vector<Eigen::Vector2d>& points);

}   // namespace angiopose::core
