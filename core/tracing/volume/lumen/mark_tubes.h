#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/lumen/blood_level.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <cstdint>

namespace angiopose::core {

/// Bits that mark a voxel.
struct TubeBits {
    std::uint8_t bright = 1;   ///< smoothed surroundings contain at least half blood
    std::uint8_t tube = 2;   ///< bright along a line
};

/// Sets `bits` in `flags` (patient axis order). A line is a place where two curvatures of the smoothed brightness are
/// strong and similar and the third is weak (Sato 1998, Frangi 1998), at one of three scales up to three voxels. Only
/// voxels with a blood fraction of at least `minFill` are evaluated. Works in blocks to save memory. Incomplete when
/// stopped.
void markTubes(const Volume& volume, const AxisOrder& order, const BloodLevel& level, double minFill, VoxelMask& flags,
               const TubeBits& bits, int threads, TracingProgress& progress);

}   // namespace angiopose::core