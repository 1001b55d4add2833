#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <cstdint>

namespace angiopose::core {

/// Bits that mark a voxel.
struct BloomingBits {
    std::uint8_t bright = 8;   ///< sources of blooming
    std::uint8_t solid = 4;   ///< never marked as blooming
    std::uint8_t blooming = 64;   ///< bit to set
};

/// Sets `blooming` in `flags` for voxels reached from a bright source along strictly decreasing values, in at most
/// `reach` steps along each axis. Blurring, motion and streaks around bone and dense contrast agent pass through every
/// intensity, including that of the lumen, whereas an adjacent vessel is brighter than the gap before it. Descents end
/// below `minFill`. Incomplete when stopped.
void markBlooming(VoxelMask& flags, const BloomingBits& bits, const VoxelOpacification& opacification, double minFill,
                  const Eigen::Vector3i& reach, TracingProgress& progress);

}   // namespace angiopose::core
