#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/tree/close_gaps.h"
#include "core/tracing/tree/open_loops.h"
#include "core/tracing/volume/voxels/cross_section.h"
#include "core/tracing/volume/voxels/tracing_options.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/vessel/vessel_tree.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

struct LumenTree {
    VesselTree tree;   ///< patient LPS; each connected component starts with one branch of generation 0
    std::vector<std::size_t> skeleton;   ///< lumen voxels on the skeleton, ascending
    LoopCount loops;
    ClosedGaps closedGaps;   ///< only if all components are traced
    int dimSubtrees = 0;   ///< number of subtrees removed as veins or organs
};

/// Traces the tree of a lumen: thinning → graph → tree → smooth centerlines with radii. `lumen` is in patient axis
/// order; `opacification` locates the wall with subvoxel accuracy. No branches if none is long enough or when stopped.
LumenTree traceLumenTree(const VoxelMask& lumen, const PointOpacification& opacification,
                         const VesselTracingOptions& options, TracingProgress& progress);

/// Returns a linear interpolator of the mask, with value 0.5 at the wall.
PointOpacification opacificationIn(const VoxelMask& mask);

}   // namespace angiopose::core
