#pragma once

#include "core/geometry/posed_camera.h"
#include "core/vessel/vessel_tree.h"

#include <cstddef>
#include <optional>

namespace angiopose::core {

/// A position on a tree: on one of its branches, between two points of that branch.
struct TreePosition {
    std::size_t branch = 0;   ///< index into VesselTree::branches
    std::size_t segment = 0;   ///< segment from the branch point with this index to the next point
    double fraction = 0.0;   ///< position along the segment, 0…1
};

/// Returns the position on the tree nearest to a 3-D point; nullopt if the tree is empty.
std::optional<TreePosition> nearestPosition(const VesselTree& tree, const Eigen::Vector3d& pointInPatient);

Eigen::Vector3d pointAt(const VesselTree& tree, const TreePosition& position);   ///< LPS, mm

/// Returns the direction of the branch at this position: the unit vector of the chord over 3 mm.
Eigen::Vector3d directionAt(const VesselTree& tree, const TreePosition& position);

std::optional<double> radiusAt(const VesselTree& tree, const TreePosition& position);   ///< mm; nullopt without radii

/// Returns the point on the tree nearest to a 3-D point; nullopt if the tree is empty.
std::optional<Eigen::Vector3d> nearestPointOnTree(const VesselTree& tree, const Eigen::Vector3d& pointInPatient);

/// Returns the point on the tree that projects nearest to a pixel; nullopt if it is farther away than `reachPx`.
std::optional<Eigen::Vector3d> pointUnderPixel(const VesselTree& tree, const PosedCamera& posedCamera,
                                               const Eigen::Vector2d& pixel, double reachPx);

}   // namespace angiopose::core
