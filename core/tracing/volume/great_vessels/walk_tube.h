#pragma once

#include "core/tracing/volume/voxels/cross_section.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// The axis of a tube, in mm along the grid's axes.
struct Tube {
    std::vector<Eigen::Vector3d> pointsMm;
    std::vector<double> radiusMm;
};

/// What is walked in.
struct TubeGround {
    BloodFill fill;
    double voxelMm = 1.0;   ///< the finest that the fill tells apart
    Eigen::Vector3d highMm = Eigen::Vector3d::Zero();   ///< middle of the last voxel; nothing is known beyond the rim
};

/// Walks both ways along the vessel around `startMm`, of about `radiusMm`, from one cross-section to the next, as long
/// as they are round and the width changes slowly. Never empty: at least the start.
Tube walkTube(const Eigen::Vector3d& startMm, double radiusMm, const TubeGround& ground);

}   // namespace angiopose::core