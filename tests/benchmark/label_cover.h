#pragma once

#include "core/imaging/volume.h"
#include "core/vessel/vessel_tree.h"

#include <cstddef>

namespace angiopose::benchmarks {

/// Coverage of a mask's own skeleton by a tree.
struct LabelCover {
    double ofSkeleton = 1.0;   ///< share of all its voxels within two voxels of the tree
    /// Share without twigs that end inside the wall of their parent vessel or within 4 mm beyond. A voxel is covered
    /// also within half a radius, where that is more, because the skeleton of a wide lumen with a rough wall runs off
    /// center.
    double ofVessels = 1.0;
    double leftOut = 0.0;   ///< share of the mask's voxels in components of which less than half is traced
    std::size_t pieces = 0;
    std::size_t traced = 0;   ///< components of which at least half is traced
    int ends = 0;   ///< free ends of the tree in the outermost two voxels of the grid
    int cuts = 0;   ///< places where the mask meets a face of the grid
};

LabelCover coverOf(const core::VoxelMask& mask, const core::VesselTree& tree);

}   // namespace angiopose::benchmarks
