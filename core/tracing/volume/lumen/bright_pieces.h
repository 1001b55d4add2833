#pragma once

#include "core/imaging/volume.h"

#include "core/tracing/volume/voxels/voxel_pieces.h"

#include <cstdint>
#include <functional>

namespace angiopose::core {

/// What bright voxels are, by the size of the piece that they belong to.
struct BrightMarks {
    std::uint8_t large = 8;   ///< bone
    std::uint8_t small = 16;   ///< chalk in the wall of a vessel
    std::uint8_t metal = 32;   ///< large, but a stent
};

/// What of a large piece is metal.
using MetalOf = std::function<VoxelPiece(const VoxelPiece& piece)>;

/// Turns what is set into `marks`. What lies within some millimetres belongs to one piece: where voxels are fine, the
/// wires of a stent and the beams of bone fall apart. Large pieces have `minLargeMl` or more.
void markBrightPieces(VoxelMask& mask, double minLargeMl, const BrightMarks& marks, const MetalOf& metalOf = {});

}   // namespace angiopose::core