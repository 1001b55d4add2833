#pragma once

#include "core/geometry/sight.h"
#include "core/vessel/vessel_tree.h"

#include <cstddef>
#include <optional>

namespace angiopose::core {

/// A place on a tree: on one of its branches, between two points of it.
struct TreePlace {
    std::size_t branch = 0;   ///< place in VesselTree::branches
    std::size_t segment = 0;   ///< from this point of the branch to the next
    double fraction = 0.0;   ///< 0…1 along the segment
};

/// The place on the tree nearest to a point in space; nothing on an empty tree.
std::optional<TreePlace> nearestPlace(const VesselTree& tree, const Eigen::Vector3d& pointInPatient);

Eigen::Vector3d pointAt(const VesselTree& tree, const TreePlace& place);   ///< LPS, mm

/// Where the branch runs to there: the chord of 3 mm of it, unit.
Eigen::Vector3d directionAt(const VesselTree& tree, const TreePlace& place);

std::optional<double> radiusAt(const VesselTree& tree, const TreePlace& place);   ///< mm; nothing without radii

/// The same as a point.
std::optional<Eigen::Vector3d> nearestOnTree(const VesselTree& tree, const Eigen::Vector3d& pointInPatient);

/// The place on the tree that projects nearest to a pixel; nothing where that is farther than `reachPx`.
std::optional<Eigen::Vector3d> placeUnderPixel(const VesselTree& tree, const Sight& sight, const Eigen::Vector2d& pixel,
                                               double reachPx);

}   // namespace angiopose::core
