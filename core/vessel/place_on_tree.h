#pragma once

#include "core/geometry/sight.h"
#include "core/vessel/vessel_tree.h"

#include <optional>

namespace angiopose::core {

/// The place on the tree nearest to a point in space; nothing on an empty tree.
std::optional<Eigen::Vector3d> nearestOnTree(const VesselTree& tree, const Eigen::Vector3d& pointInPatient);

/// The place on the tree that projects nearest to a pixel; nothing where that is farther than `reachPx`.
std::optional<Eigen::Vector3d> placeUnderPixel(const VesselTree& tree, const Sight& sight, const Eigen::Vector2d& pixel,
                                               double reachPx);

}   // namespace angiopose::core