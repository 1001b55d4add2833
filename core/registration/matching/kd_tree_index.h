#pragma once

#include "core/registration/matching/point_index.h"

#include <memory>

namespace angiopose::core {

/// KD-tree over points of the image, at least one: exact for any query, O(log M) each. The reproduction mode of
/// ALGORITHMS §1.
std::unique_ptr<PointIndex> makeKdTreeIndex(std::vector<Eigen::Vector2d> pointsPx);

}   // namespace angiopose::core