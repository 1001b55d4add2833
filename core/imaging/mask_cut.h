#pragma once

#include "core/imaging/mask_edit.h"

#include <vector>

namespace angiopose::core {

enum class CutSide { Inside, Outside };

/// A closed outline drawn in a slice, cut through what lies within so many mm before and behind it.
struct MaskCut {
    SliceGrid slice;
    std::vector<Eigen::Vector2d> outline;   ///< pixels of the slice
    CutSide side = CutSide::Inside;   ///< what is removed
    double halfDepthMm = 0.0;   ///< 0: the slice alone
};

/// The voxels of the mask that it removes.
VoxelPlaces cutVoxels(const VoxelMask& mask, const MaskCut& cut);

}   // namespace angiopose::core
