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
    VesselTree tree;   ///< patient LPS; one branch of generation 0 begins each piece
    std::vector<std::size_t> skeleton;   ///< voxels of the lumen, ascending
    LoopCount loops;
    ClosedGaps closedGaps;   ///< where all pieces are asked for
    int dimParts = 0;   ///< left out: veins and organs
};

/// Thinning → graph → tree → smooth centrelines with radii. `lumen` has patient axis order; `fill` tells where its wall
/// lies below the voxel. No branches when nothing is long enough, or when stopped.
LumenTree lumenTree(const VoxelMask& lumen, const BloodFill& fill, const VesselTracingOptions& options,
                    TracingProgress& progress);

/// Linear interpolation between the voxels of a mask: one half at its wall.
BloodFill fillOf(const VoxelMask& mask);

}   // namespace angiopose::core