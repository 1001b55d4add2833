#pragma once

#include "core/registration/matching/point_index.h"

#include <memory>

namespace angiopose::core {

/// Creates a k-d tree of one or more image points, which is exact for any query at O(log M) each. Used by the
/// reproduction mode of ALGORITHMS §1.
std::unique_ptr<PointIndex> makeKdTreeIndex(std::vector<Eigen::Vector2d> pointsPx);

}   // namespace angiopose::core
