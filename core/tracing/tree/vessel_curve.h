#pragma once

#include "core/tracing/tree/branch_paths.h"
#include "core/tracing/volume/voxels/cross_section.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <vector>

namespace angiopose::core {

/// Centerline in mm along the grid's axes, with the radius at each point.
struct VesselCurve {
    std::vector<Eigen::Vector3d> pointsMm;
    std::vector<double> radiusMm;
};

struct CurveSettings {
    double voxelMm = 1.0;   ///< smallest spacing of the grid
    double pointSpacingMm = 1.0;
    Eigen::Vector3d lowMm = Eigen::Vector3d::Zero();   ///< outermost voxel centers
    Eigen::Vector3d highMm = Eigen::Vector3d::Zero();
    TracingProgress* progress = nullptr;   ///< if it requests a stop, the curve is incomplete
};

/// Finished curves on which a path begins and ends; null for an end without a curve.
struct CurveNeighbors {
    const VesselCurve* parent = nullptr;
    const VesselCurve* loopTarget = nullptr;
    bool isSelfLoop = false;
};

/// Converts a path of voxels to a smooth curve through the centers of its cross-sections. Inside the parent vessel
/// nothing can be measured, so the curve runs straight to the parent's centerline, also where it closes a loop. A free
/// end stops one radius before the tip of the lumen, or at the volume boundary if that cuts the vessel.
VesselCurve fitVesselCurve(const BranchPath& path, const CurveNeighbors& neighbors,
                           const PointOpacification& opacification, const CurveSettings& settings);

}   // namespace angiopose::core
