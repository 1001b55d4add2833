#pragma once

#include "core/tracing/tree/branch_paths.h"
#include "core/tracing/tree/vessel_curve.h"
#include "core/tracing/volume/voxels/cross_section.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/vessel/vessel_tree.h"

#include <functional>
#include <vector>

namespace angiopose::core {

/// The fill along a path, asked for near it.
using FillOfPath = std::function<BloodFill(const BranchPath& path)>;

/// Paths, parents before their children, as smooth centred curves, in their order; fills, paths and curves are in mm
/// along the axes of `grid`. Empty when stopped.
std::vector<VesselCurve> curvesOfPaths(const std::vector<BranchPath>& paths, const FillOfPath& fillOf,
                                       const VolumeGeometry& grid, double pointSpacingMm, TracingProgress& progress);

/// A curve as a branch of a tree, patient LPS.
VesselBranch branchOfCurve(const VesselCurve& curve, int id, int generation, const VolumeGeometry& grid);

/// The same of all paths: ids 1, 2, … in their order. No branches when stopped.
VesselTree treeOfPaths(const std::vector<BranchPath>& paths, const FillOfPath& fillOf, const VolumeGeometry& grid,
                       double pointSpacingMm, TracingProgress& progress);

}   // namespace angiopose::core
