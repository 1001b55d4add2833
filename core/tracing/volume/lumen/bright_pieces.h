#pragma once

#include "core/imaging/volume.h"

#include "core/tracing/volume/voxels/voxel_pieces.h"

#include <cstdint>
#include <functional>

namespace angiopose::core {

/// Marks for bright voxels, chosen by the size of their connected component.
struct BrightMarks {
    std::uint8_t large = 8;   ///< bone
    std::uint8_t small = 16;   ///< calcified plaque in a vessel wall
    std::uint8_t metal = 32;   ///< stent (part of a large component)
};

/// Selects the metal part of a large component.
using MetalOf = std::function<VoxelPiece(const VoxelPiece& piece)>;

/// Replaces set voxels by `marks`. Voxels within a few millimeters of each other form one component, because stent
/// struts and bone trabeculae are disconnected at fine voxel sizes. Large components have at least `minLargeMl`.
void markBrightPieces(VoxelMask& mask, double minLargeMl, const BrightMarks& marks, const MetalOf& metalOf = {});

}   // namespace angiopose::core
