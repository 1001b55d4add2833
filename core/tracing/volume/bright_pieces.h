#pragma once

#include "core/imaging/volume.h"

#include "core/tracing/volume/voxel_pieces.h"

#include <cstdint>
#include <functional>

namespace core {

/// What bright voxels are, by the size of the piece that they belong to.
struct BrightMarks {
    std::uint8_t large = 8;   ///< bone
    std::uint8_t small = 16;   ///< chalk in the wall of a vessel
    std::uint8_t metal = 32;   ///< large, but a stent
};

using IsMetal = std::function<bool(const VoxelPiece& piece)>;

/// Turns what is set into `marks`. What lies within some millimetres belongs to one piece: where voxels are fine, the
/// wires of a stent and the beams of bone fall apart. Large pieces have `leastLargeMl` or more; those that `isMetal`
/// agrees to are metal.
void markBrightPieces(VoxelMask& mask, double leastLargeMl, const BrightMarks& marks, const IsMetal& isMetal = {});

}   // namespace core
