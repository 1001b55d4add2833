#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/lumen/lumen_levels.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/cross_section.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/tracing/volume/voxels/voxel_components.h"

namespace angiopose::core {

/// Lumen candidates, in patient axis order.
struct SegmentedLumen {
    /// 2: contrast-enhanced core of a wide vessel; 1: rim of such a core, or thin vessel (possibly below the
    /// threshold).
    VoxelMask clearLumen;
    VoxelComponent voxelsBesideStruts;   ///< see `growLumenBesideStruts`
};

/// Segments the lumen. Excludes most bone, which has cortical sheets and an inhomogeneous interior. Incomplete when
/// stopped.
SegmentedLumen segmentLumen(const Volume& volume, const AxisOrder& order, const LumenLevels& level, int threads,
                            TracingProgress& progress);

/// Returns the linearly interpolated opacification at each point of the scan; bright voxels outside `lumen` (bone next
/// to a vessel) count as tissue, voxels of value 2 (filled holes) as lumen. `lumen` and `order` must have the same
/// geometry; all arguments must outlive the result.
PointOpacification opacificationIn(const Volume& volume, const AxisOrder& order, const LumenLevels& level,
                                   const VoxelMask& lumen);

}   // namespace angiopose::core
