#pragma once

#include "core/geometry/rigid_transform.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// One way that a wire or catheter may take through the tree, and the pose that goes with it (ALGORITHMS §6.22). Ways
/// whose visible parts are nearly the same count as one.
struct WirePath {
    std::vector<int> branchIds;   ///< in the order that the wire takes them; its tip lies in the last
    Eigen::Vector3d tipInPatient = Eigen::Vector3d::Zero();   ///< LPS, mm, on the branch's axis
    double probability = 0.0;   ///< 0…1, among all ways looked at and none of them
    double offAxisMm = 0.0;   ///< rms distance of the wire from the vessels' axes, in the image, at their depth
    double followedShare = 0.0;   ///< of the wire's length in the image
    RigidTransform cameraFromPatient;
    /// The axes beside the wire, about 2 mm apart, up to the tip. Not kept in files.
    std::vector<Eigen::Vector3d> courseInPatient;
};

}   // namespace angiopose::core
