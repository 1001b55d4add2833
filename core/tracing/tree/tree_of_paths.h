#pragma once

#include "core/tracing/tree/branch_paths.h"
#include "core/tracing/volume/voxels/cross_section.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/vessel/vessel_tree.h"

#include <functional>
#include <vector>

namespace angiopose::core {

/// The fill along a path, asked for near it.
using FillOfPath = std::function<BloodFill(const BranchPath& path)>;

/// Paths, parents before their children, as smooth centrelines with radii; ids 1, 2, … in their order, patient LPS.
/// Fills and paths are in mm along the axes of `grid`. No branches when stopped.
VesselTree treeOfPaths(const std::vector<BranchPath>& paths, const FillOfPath& fillOf, const VolumeGeometry& grid,
                       double pointSpacingMm, TracingProgress& progress);

}   // namespace angiopose::core
