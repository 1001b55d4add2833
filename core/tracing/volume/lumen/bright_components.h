#pragma once

#include "core/imaging/volume.h"

#include "core/tracing/volume/voxels/voxel_components.h"

#include <cstdint>
#include <functional>

namespace angiopose::core {

/// Marks for bright voxels, chosen by the size of their connected component.
struct BrightLabels {
    std::uint8_t large = 8;   ///< bone
    std::uint8_t small = 16;   ///< calcified plaque in a vessel wall
    std::uint8_t metal = 32;   ///< stent (part of a large component)
};

/// Returns the metal part of a large component.
using MetalSelector = std::function<VoxelComponent(const VoxelComponent& piece)>;

/// Replaces set voxels by `marks`. Voxels within a few millimeters of each other form one component, because stent
/// struts and bone trabeculae are disconnected at fine voxel sizes. Large components have at least `minLargeMl`.
void labelBrightComponents(VoxelMask& mask, double minLargeMl, const BrightLabels& marks,
                           const MetalSelector& selectMetal = {});

}   // namespace angiopose::core
