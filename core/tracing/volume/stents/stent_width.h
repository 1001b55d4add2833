#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/tracing/volume/voxels/voxel_pieces.h"

#include <cstdint>

namespace angiopose::core {

/// Whether a stented vessel is so wide that its blood is separate from the blur of the wires: voxels with `core` set in
/// `flags` lie well away from the wires, but not far. Only then can the wires be distinguished from the blood and form
/// its wall.
bool isWideStent(const VoxelPiece& wires, const VoxelMask& flags, std::uint8_t core, int threads,
                 TracingProgress& progress);

}   // namespace angiopose::core