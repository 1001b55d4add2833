#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/tracing_progress.h"
#include "core/tracing/volume/voxels/voxel_components.h"

#include <cstdint>

namespace angiopose::core {

/// Returns whether a stented vessel is wide enough for its lumen to be separate from the blur of the struts: voxels
/// with `core` set in `flags` lie well away from the struts, but not far. Only then can the struts be distinguished
/// from the lumen and form its wall.
bool isWideStent(const VoxelComponent& wires, const VoxelMask& flags, std::uint8_t core, int threads,
                 TracingProgress& progress);

}   // namespace angiopose::core
