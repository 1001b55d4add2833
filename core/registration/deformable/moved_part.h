#pragma once

#include "core/registration/deformable/deform_vessels.h"

#include <optional>

namespace angiopose::core {

/// Part of the tree on one side of a plane across a patient axis that moved as a whole relative to the rest.
struct MovedPart {
    Eigen::Vector3d side;   ///< unit vector, patient axes: side on which the part lies
    double share = 0.0;   ///< fraction of the tree's length
    Eigen::Vector3d shift;   ///< mm, patient axes: mean motion of the part relative to the rest
};

/// Smaller of the two rigid parts that explain most of the motion, if such parts exist.
std::optional<MovedPart> movedPart(const VesselTree& tree, const DeformableResult& result);

}   // namespace angiopose::core
