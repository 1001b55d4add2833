#pragma once

#include "core/geometry/rigid_transform.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Possible path of a guidewire or catheter through the tree, with the corresponding pose (ALGORITHMS §6.22). Paths
/// whose visible parts nearly coincide count as one.
struct WirePath {
    std::vector<int> branchIds;   ///< in order along the wire; the last one contains the tip
    Eigen::Vector3d tipInPatient = Eigen::Vector3d::Zero();   ///< position of the tip on the branch centerline, LPS, mm
    double probability = 0.0;   ///< 0…1, among all considered paths and the possibility that none of them is right
    double offAxisMm = 0.0;   ///< RMS in-plane distance between the wire and the centerlines, at their depth
    double followedShare = 0.0;   ///< fraction of the wire's length in the image that follows the path
    RigidTransform cameraFromPatient;
    /// Points on the centerlines along the wire, about 2 mm apart, up to the tip. Not saved.
    std::vector<Eigen::Vector3d> courseInPatient;
};

}   // namespace angiopose::core
