#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Distance from each voxel of a mask to the nearest one outside it, in mm from centre to centre. Beyond the grid's rim
/// lies nothing: a vessel that is cut off there stays as wide as it is.
struct DistanceMap {
    VolumeGeometry geometry;
    double unitMm = 1.0;   ///< 1/256 of the smallest spacing: two bytes a voxel, exact to 1/200 of a voxel
    std::vector<std::uint16_t> units;

    double mm(std::size_t voxel) const { return unitMm * units[voxel]; }
};

/// Separable exact distance transform (Felzenszwalb, Huttenlocher 2012), anisotropic. Incomplete when stopped.
DistanceMap distanceMap(const VoxelMask& mask, int threads, TracingProgress& progress);

}   // namespace angiopose::core