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
    std::vector<std::size_t> skeleton;   ///< voxels of the lumen, ascending
    LoopCount loops;
    ClosedGaps closedGaps;   ///< if all components are traced
    int dimParts = 0;   ///< parts removed as veins and organs
};

/// Traces the tree of a lumen: thinning → graph → tree → smooth centerlines with radii. `lumen` has patient axis order;
/// `fill` locates its wall with subvoxel accuracy. No branches if nothing is long enough, or when stopped.
LumenTree lumenTree(const VoxelMask& lumen, const BloodFill& fill, const VesselTracingOptions& options,
                    TracingProgress& progress);

/// Linear interpolation between the voxels of a mask; the value is one half at its wall.
BloodFill fillOf(const VoxelMask& mask);

}   // namespace angiopose::core