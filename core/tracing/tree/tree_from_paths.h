#pragma once

#include "core/tracing/tree/branch_paths.h"
#include "core/tracing/tree/vessel_curve.h"
#include "core/tracing/volume/voxels/cross_section.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/vessel/vessel_tree.h"

#include <functional>
#include <vector>

namespace angiopose::core {

/// Returns the opacification around a path, evaluated only near that path.
using PathOpacification = std::function<PointOpacification(const BranchPath& path)>;

/// Converts paths to smooth centered curves in the same order; parents must precede their children. Opacifications,
/// paths and curves are in mm along the axes of `grid`. Empty when stopped.
std::vector<VesselCurve> curvesFromPaths(const std::vector<BranchPath>& paths,
                                         const PathOpacification& opacificationAlong, const VolumeGeometry& grid,
                                         double pointSpacingMm, TracingProgress& progress);

/// Converts a curve to a branch of a tree, patient LPS.
VesselBranch branchFromCurve(const VesselCurve& curve, int id, int generation, const VolumeGeometry& grid);

/// Converts all paths to a tree with ids 1, 2, … in their order; no branches when stopped.
VesselTree treeFromPaths(const std::vector<BranchPath>& paths, const PathOpacification& opacificationAlong,
                         const VolumeGeometry& grid, double pointSpacingMm, TracingProgress& progress);

}   // namespace angiopose::core
