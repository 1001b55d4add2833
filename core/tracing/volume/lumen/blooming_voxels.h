#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <Eigen/Core>
#include <cstdint>

namespace angiopose::core {

/// Marks of a voxel.
struct BloomingBits {
    std::uint8_t bright = 8;   ///< skirts lie around these
    std::uint8_t solid = 4;   ///< never in a skirt
    std::uint8_t blooming = 64;   ///< what is set
};

/// Sets `skirt` in `flags` wherever it only ever gets darker on the way there from something bright, in at most `reach`
/// steps along each axis: blurring, motion and streaks around bone and dense contrast medium pass every brightness,
/// that of blood too, while a vessel beside them is brighter again than what lies between. Ways end at less than
/// `minFill`. Incomplete when stopped.
void markBlooming(VoxelMask& flags, const BloomingBits& bits, const VoxelFill& fill, double minFill,
                  const Eigen::Vector3i& reach, TracingProgress& progress);

}   // namespace angiopose::core