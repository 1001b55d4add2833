#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/lumen/lumen_levels.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <cstdint>

namespace angiopose::core {

/// Bits that mark a voxel.
struct TubeBits {
    std::uint8_t bright = 1;   ///< mean opacification of the smoothed surroundings is at least 0.5
    std::uint8_t tube = 2;   ///< bright line (thin vessel)
};

/// Sets `bits` in `flags` (patient axis order). A voxel lies on a line if two principal curvatures of the smoothed
/// intensity are strong and similar and the third is weak (Sato 1998, Frangi 1998), at one of three scales up to three
/// voxels. Evaluates only voxels with an opacification of at least `minFill`, block by block to save memory. Incomplete
/// when stopped.
void markTubes(const Volume& volume, const AxisOrder& order, const LumenLevels& level, double minFill, VoxelMask& flags,
               const TubeBits& bits, int threads, TracingProgress& progress);

}   // namespace angiopose::core
