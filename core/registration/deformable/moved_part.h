#pragma once

#include "core/registration/deformable/deform_vessels.h"

#include <optional>

namespace angiopose::core {

/// A part of the tree, cut off by a plane across a patient axis, that moved as a whole against the rest.
struct MovedPart {
    Eigen::Vector3d side;   ///< unit, patient axes: where the part lies
    double share = 0.0;   ///< of the tree's length
    Eigen::Vector3d shift;   ///< mm, patient axes: mean of the part against the rest
};

/// The smaller of two rigid parts that explain most of the motion, if there are such parts.
std::optional<MovedPart> movedPart(const VesselTree& tree, const DeformableResult& result);

}   // namespace angiopose::core
