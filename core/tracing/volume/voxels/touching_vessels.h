#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/distance_map.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace angiopose::core {

/// Opacification of a voxel: 0 in tissue, 1 in the lumen.
using VoxelOpacification = std::function<double(int i, int j, int k)>;

/// Returns the inner voxels of vessels that merely touch those of the seeds: every path to them leads through voxels at
/// the wall (`necks` of the seeds no wider than a voxel), and they are clearly brighter or darker, like veins in the
/// arterial phase. Behind a stenosis, the opacification is the same. Ascending; empty if there are no such voxels.
std::vector<std::uint32_t> differentlyOpacifiedVoxels(const DistanceMap& distances,
                                                      const std::vector<std::uint16_t>& necks,
                                                      const VoxelOpacification& opacification);

}   // namespace angiopose::core
