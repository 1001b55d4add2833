#pragma once

#include "core/imaging/mask_edit.h"

namespace angiopose::core {

enum class BrushMode { Paint, Erase };

/// A brush that changes all voxels within its radius along a path.
struct MaskBrush {
    BrushMode mode = BrushMode::Paint;
    double radiusMm = 2.0;
    const Volume* scan = nullptr;   ///< if set, the brush changes only voxels with at least `minValue` in this scan
    double minValue = 0.0;
};

/// Part of a brush stroke between two pointer positions.
struct BrushStep {
    Eigen::Vector3d fromInPatient;
    Eigen::Vector3d toInPatient;
};

/// Returns the voxels that the brush would change. In a slice, these are the voxels cut by the slice and, if the mask
/// is coarser than the slice, the voxels displayed in it; in 3-D, all voxels within the radius.
VoxelIndices brushSlice(const VoxelMask& mask, const SliceGrid& slice, const MaskBrush& brush, const BrushStep& step);
VoxelIndices brushVolume(const VoxelMask& mask, const MaskBrush& brush, const BrushStep& step);

}   // namespace angiopose::core
