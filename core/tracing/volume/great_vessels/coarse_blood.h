#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/cross_section.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

namespace angiopose::core {

constexpr double usualBlockMm = 1.5;
constexpr double fineBlockMm = 1.0;   ///< finer blocks, for scans whose widest arteries are those of the neck

/// Fill of a scan averaged over blocks of one size, whatever its voxel size: sufficient for wide vessels, free of most
/// noise, small in memory, and the same for the same patient.
struct CoarseBlood {
    VoxelGrid<std::uint8_t> shares;   ///< 200 = fully opacified; axes as in the scan
    VoxelMask lumen;   ///< blocks that are at least half full
    double finestMm = 0.0;   ///< finest resolved length: block length or the shortest voxel side

    /// Linear interpolation, for points in mm along the axes from the center of the first block.
    BloodFill fill() const;
};

/// Computes the block means. `fill` counts inside `lumen`, and elsewhere only below one half, to exclude other bright
/// structures. Incomplete when stopped.
CoarseBlood coarseBlood(const VoxelMask& lumen, const VoxelFill& fill, int threads, TracingProgress& progress,
                        double blockMm = usualBlockMm);

}   // namespace angiopose::core