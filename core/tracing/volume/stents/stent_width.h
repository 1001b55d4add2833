#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/tracing/volume/voxels/voxel_pieces.h"

#include <cstdint>

namespace angiopose::core {

/// Whether the vessel of a stent is so wide that its blood stands clear of what the wires blur: voxels that carry
/// `core` in `flags` lie well away from the wires, but not far. Only then can the wires be told from the blood, and be
/// its wall.
bool isWideStent(const VoxelPiece& wires, const VoxelMask& flags, std::uint8_t core, int threads,
                 TracingProgress& progress);

}   // namespace angiopose::core