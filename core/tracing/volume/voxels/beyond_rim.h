#pragma once

#include "core/imaging/volume.h"

namespace angiopose::core {

/// Mask with a margin: voxel p of the original is p + offset here. Its outermost voxels are clear.
struct WiderMask {
    VoxelMask mask;
    Eigen::Vector3i offset = Eigen::Vector3i::Ones();
};

/// Continues vessels cut by the grid's rim beyond it by a little more than their radius. Thinning shortens a vessel's
/// end by about that much and would otherwise lose the last stretch, or a short wide trunk altogether. Vessels that run
/// along the rim are not continued.
WiderMask continuedBeyondRim(const VoxelMask& mask);

}   // namespace angiopose::core