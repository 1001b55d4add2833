#pragma once

#include "core/imaging/volume.h"
#include "core/vessel/vessel_tree.h"

#include <cstddef>

namespace angiopose::benchmarks {

/// How much of a mask's own skeleton a tree follows.
struct LabelCover {
    double ofSkeleton = 1.0;   ///< share of all its voxels within two voxels of the tree
    /// Without twigs that end within the wall they leave, or 4 mm beyond; within half a radius where that is more. The
    /// skeleton of a wide lumen with a rough wall runs beside its middle.
    double ofVessels = 1.0;
    double leftOut = 0.0;   ///< share of the mask's voxels in pieces that the tree has less than half of
    std::size_t pieces = 0;
    std::size_t traced = 0;   ///< pieces of which it has half
    int ends = 0;   ///< free ends of the tree in the outermost two voxels of the grid
    int cuts = 0;   ///< places where the mask meets a face of the grid
};

LabelCover coverOf(const core::VoxelMask& mask, const core::VesselTree& tree);

}   // namespace angiopose::benchmarks
