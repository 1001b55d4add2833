#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/lumen/blood_level.h"
#include "core/tracing/volume/voxels/axis_order.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <cstdint>

namespace angiopose::core {

/// Marks of a voxel.
struct TubeBits {
    std::uint8_t bright = 1;   ///< its surroundings hold half or more of blood, noise smoothed away
    std::uint8_t tube = 2;   ///< it is bright along a line
};

/// Sets `bits` in `flags` (patient axis order). A line is where two curvatures of the smoothed brightness are strong
/// and alike and the third is weak (Sato 1998, Frangi 1998), at one of three scales up to three voxels. Only voxels
/// that hold at least `minFill` of blood are looked at. Works in blocks, so that it needs little memory. Incomplete
/// when stopped.
void markTubes(const Volume& volume, const AxisOrder& order, const BloodLevel& level, double minFill, VoxelMask& flags,
               const TubeBits& bits, int threads, TracingProgress& progress);

}   // namespace angiopose::core