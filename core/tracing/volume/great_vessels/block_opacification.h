#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/cross_section.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

namespace angiopose::core {

constexpr double defaultBlockMm = 1.5;
constexpr double fineBlockMm = 1.0;   ///< finer block size, for scans whose widest arteries are in the neck

/// Opacification of a scan averaged over blocks of fixed size, independent of the voxel size: sufficient for wide
/// vessels, low in noise, and small in memory.
struct BlockOpacification {
    VoxelGrid<std::uint8_t> shares;   ///< mean opacification; 200 = fully opacified; axes as in the scan
    VoxelMask lumen;   ///< blocks with a mean opacification of at least 0.5
    double resolutionMm = 0.0;   ///< finest resolved length: block length or the shortest voxel side

    /// Returns the linear interpolation for points in mm along the axes, from the center of the first block.
    PointOpacification fill() const;
};

/// Returns the block means of `fill`. Outside `lumen`, values of one half or more count as 0 to exclude other bright
/// structures. Incomplete when stopped.
BlockOpacification averageInBlocks(const VoxelMask& lumen, const VoxelOpacification& fill, int threads,
                                   TracingProgress& progress, double blockMm = defaultBlockMm);

}   // namespace angiopose::core
