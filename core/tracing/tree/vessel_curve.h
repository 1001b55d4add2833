#pragma once

#include "core/tracing/tree/branch_paths.h"
#include "core/tracing/volume/voxels/cross_section.h"

#include <vector>

namespace angiopose::core {

/// A centreline in mm along the grid's axes, with the radius at each point.
struct VesselCurve {
    std::vector<Eigen::Vector3d> pointsMm;
    std::vector<double> radiusMm;
};

struct CurveSettings {
    double voxelMm = 1.0;   ///< smallest spacing of the grid
    double pointSpacingMm = 1.0;
    Eigen::Vector3d lowMm = Eigen::Vector3d::Zero();   ///< outermost voxel centres
    Eigen::Vector3d highMm = Eigen::Vector3d::Zero();
};

/// A path of voxels as a smooth curve through the centres of its cross-sections. `parent` is the finished curve that it
/// leaves, or null: within it there is nothing to measure, so that the curve runs straight to its axis. A free end
/// reaches as near to the tip as the vessel is wide, and to the rim of the volume where that cuts it off.
VesselCurve vesselCurve(const BranchPath& path, const VesselCurve* parent, const BloodFill& fill,
                        const CurveSettings& settings);

}   // namespace angiopose::core