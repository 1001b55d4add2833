#pragma once

#include "core/imaging/mask_edit.h"

#include <vector>

namespace angiopose::core {

enum class CutSide { Inside, Outside };

/// A closed outline drawn in a slice, for cutting the mask up to a given distance in front of and behind the slice.
struct MaskCut {
    SliceGrid slice;
    std::vector<Eigen::Vector2d> outline;   ///< in pixels of the slice
    CutSide side = CutSide::Inside;   ///< side to remove
    double halfDepthMm = 0.0;   ///< depth of the cut on either side of the slice; 0 cuts only the slice itself
};

/// Returns the voxels of the mask that the cut removes.
VoxelIndices cutVoxels(const VoxelMask& mask, const MaskCut& cut);

}   // namespace angiopose::core
