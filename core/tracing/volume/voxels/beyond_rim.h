#pragma once

#include "core/imaging/volume.h"

namespace angiopose::core {

/// A mask with more room around: voxel p of the original is p + offset here. Its outermost voxels are clear.
struct WiderMask {
    VoxelMask mask;
    Eigen::Vector3i offset = Eigen::Vector3i::Ones();
};

/// Lets vessels that the grid's rim cuts across go on beyond it by a little more than their radius. Thinning eats a
/// vessel's end by about that much, and would lose the last stretch, or a short wide trunk altogether. Vessels that run
/// along the rim do not go on.
WiderMask continuedBeyondRim(const VoxelMask& mask);

}   // namespace angiopose::core