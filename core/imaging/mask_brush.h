#pragma once

#include "core/imaging/mask_edit.h"

namespace angiopose::core {

enum class MaskAim { Paint, Erase };

/// What a brush does on its way: of a path, all that lies within the radius.
struct MaskBrush {
    MaskAim aim = MaskAim::Paint;
    double radiusMm = 2.0;
    const Volume* scan = nullptr;   ///< only voxels whose value in it is not below `minValue`; null: all
    double minValue = 0.0;
};

/// The part of a stroke between two places of the pointer.
struct BrushStep {
    Eigen::Vector3d fromInPatient;
    Eigen::Vector3d toInPatient;
};

/// The voxels that are not yet as the brush wants them: those whose part of space the slice cuts and those that it
/// shows (of a mask coarser than the slice), or those in space.
VoxelPlaces brushedInSlice(const VoxelMask& mask, const SliceGrid& slice, const MaskBrush& brush,
                           const BrushStep& step);
VoxelPlaces brushedInSpace(const VoxelMask& mask, const MaskBrush& brush, const BrushStep& step);

}   // namespace angiopose::core
