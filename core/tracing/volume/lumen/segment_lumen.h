#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/lumen/blood_level.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/cross_section.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/tracing/volume/voxels/voxel_pieces.h"

namespace angiopose::core {

/// Voxels that can be lumen, in patient axis order.
struct SegmentedLumen {
    /// 2 where the scan is evenly bright as blood (the core of wide vessels), 1 what belongs around such cores and what
    /// is bright along lines (thin vessels, also below the threshold).
    VoxelMask clear;
    VoxelPiece besideWires;   ///< see `lumenBesideWires`
};

/// Bone is mostly no lumen: its shells are sheets, its inside is uneven. Incomplete when stopped.
SegmentedLumen segmentLumen(const Volume& volume, const AxisOrder& order, const BloodLevel& level, int threads,
                            TracingProgress& progress);

/// How far each place of the scan is filled with blood, by linear interpolation; bright voxels that are not of `lumen`
/// (bone beside a vessel) count as tissue, voxels of value 2 (filled holes) as blood. `lumen` and `order` have the same
/// geometry; all must outlive the result.
BloodFill fillOf(const Volume& volume, const AxisOrder& order, const BloodLevel& level, const VoxelMask& lumen);

}   // namespace angiopose::core