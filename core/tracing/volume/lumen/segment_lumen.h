#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/lumen/blood_level.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/cross_section.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/tracing/volume/voxels/voxel_pieces.h"

namespace angiopose::core {

/// Lumen candidates, in patient axis order.
struct SegmentedLumen {
    /// 2 for voxels as bright as blood in homogeneous surroundings (cores of wide vessels), 1 for voxels around such
    /// cores and bright along lines (thin vessels, also below the threshold).
    VoxelMask clear;
    VoxelPiece besideWires;   ///< see `lumenBesideWires`
};

/// Segments the lumen; bone is mostly excluded because its cortex forms sheets and its inside is inhomogeneous.
/// Incomplete when stopped.
SegmentedLumen segmentLumen(const Volume& volume, const AxisOrder& order, const BloodLevel& level, int threads,
                            TracingProgress& progress);

/// Fraction of blood at each point of the scan, by linear interpolation; bright voxels outside `lumen` (bone next to a
/// vessel) count as tissue, voxels of value 2 (filled holes) as blood. `lumen` and `order` must have the same geometry;
/// all arguments must outlive the result.
BloodFill fillOf(const Volume& volume, const AxisOrder& order, const BloodLevel& level, const VoxelMask& lumen);

}   // namespace angiopose::core