#pragma once

#include "core/tracing/tree/branch_paths.h"
#include "core/tracing/volume/voxels/cross_section.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

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
    TracingProgress* progress = nullptr;   ///< a curve is not finished when it says stop
};

/// The finished curves that a path begins and ends on; null: there is none.
struct CurveNeighbors {
    const VesselCurve* parent = nullptr;
    const VesselCurve* endsOn = nullptr;
    bool endsOnItself = false;
};

/// A path of voxels as a smooth curve through the centres of its cross-sections. Within the vessel that it leaves there
/// is nothing to measure, so that the curve runs straight to its axis, also where it closes a loop. A free end
/// reaches as near to the tip as the vessel is wide, and to the rim of the volume where that cuts it off.
VesselCurve vesselCurve(const BranchPath& path, const CurveNeighbors& beside, const BloodFill& fill,
                        const CurveSettings& settings);

}   // namespace angiopose::core