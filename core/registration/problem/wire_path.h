#pragma once

#include "core/geometry/rigid_transform.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Possible path of a wire or catheter through the tree, with the corresponding pose (ALGORITHMS §6.22). Paths with
/// nearly the same visible part count as one.
struct WirePath {
    std::vector<int> branchIds;   ///< in the order along the wire; the tip lies in the last
    Eigen::Vector3d tipInPatient = Eigen::Vector3d::Zero();   ///< LPS, mm, on the branch's axis
    double probability = 0.0;   ///< 0…1, relative to all paths considered and to none of them
    double offAxisMm = 0.0;   ///< RMS distance of the wire from the vessel axes, in the image, at their depth
    double followedShare = 0.0;   ///< share of the wire's length in the image
    RigidTransform cameraFromPatient;
    /// Axes along the wire, about 2 mm apart, up to the tip. Not stored in files.
    std::vector<Eigen::Vector3d> courseInPatient;
};

}   // namespace angiopose::core
