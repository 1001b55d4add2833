#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/voxels/cross_section.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

namespace angiopose::core {

constexpr double usualBlockMm = 1.5;
constexpr double fineBlockMm = 1.0;   ///< where the widest arteries are those of the neck

/// How far the places of a scan are filled with blood, as means over blocks of one size whatever its voxels: enough for
/// wide vessels, free of most noise, a small part of the scan's memory, and the same for the same patient.
struct CoarseBlood {
    VoxelGrid<std::uint8_t> shares;   ///< 200 = filled; axes as those of the scan
    VoxelMask lumen;   ///< blocks that are at least half full
    double finestMm = 0.0;   ///< what the blocks can tell apart: as long as they are, or the shortest side of a voxel

    /// By linear interpolation, at points in mm along the axes from the middle of the first block.
    BloodFill fill() const;
};

/// `fill` counts where `lumen` is set and below one half, not where something else is bright. Incomplete when stopped.
CoarseBlood coarseBlood(const VoxelMask& lumen, const VoxelFill& fill, int threads, TracingProgress& progress,
                        double blockMm = usualBlockMm);

}   // namespace angiopose::core