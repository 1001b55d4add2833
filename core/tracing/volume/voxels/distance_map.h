#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Distance from each voxel of a mask to the nearest voxel outside the mask, in mm between centers. Space beyond the
/// grid does not count as outside, so a vessel cut off at the boundary keeps its width.
struct DistanceMap {
    VolumeGeometry geometry;
    double unitMm = 1.0;   ///< 1/256 of the smallest spacing: 2 bytes per voxel, exact to 1/200 of a voxel
    std::vector<std::uint16_t> units;

    double mm(std::size_t voxel) const { return unitMm * units[voxel]; }
};

/// Computes the exact separable distance transform (Felzenszwalb, Huttenlocher 2012) for anisotropic voxels. Incomplete
/// when stopped.
DistanceMap distanceMap(const VoxelMask& mask, int threads, TracingProgress& progress);

}   // namespace angiopose::core
