#pragma once

#include "core/tracing/volume/voxels/cross_section.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Axis of a tube, in mm along the grid's axes.
struct Tube {
    std::vector<Eigen::Vector3d> pointsMm;
    std::vector<double> radiusMm;
};

/// Data that the tracking runs on.
struct TubeGround {
    BloodFill fill;
    double voxelMm = 1.0;   ///< finest length resolved by the fill
    Eigen::Vector3d highMm = Eigen::Vector3d::Zero();   ///< center of the last voxel; tracking ends at the rim
};

/// Tracks a vessel both ways from `startMm`, of about `radiusMm`, from one cross-section to the next, as long as they
/// are round and the width changes slowly. Contains at least the start.
Tube walkTube(const Eigen::Vector3d& startMm, double radiusMm, const TubeGround& ground);

}   // namespace angiopose::core