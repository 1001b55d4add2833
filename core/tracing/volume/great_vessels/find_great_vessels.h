#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/great_vessels/coarse_blood.h"
#include "core/tracing/volume/great_vessels/great_vessels.h"
#include "core/tracing/volume/lumen/segment_lumen.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <vector>

namespace angiopose::core {

/// A lumen with all voxels that belong to it, and its great vessels.
struct LumenWithGreatVessels {
    VoxelMask lumen;
    std::vector<GreatVessel> great;
};

/// Finds the great vessels. In scans with stents, searches with and without the lumen beside the wires, because
/// tracking ends where the width changes abruptly between sections, either hidden by wires or widened by a stent; keeps
/// the result whose first vessel has the higher worth. Incomplete when stopped.
LumenWithGreatVessels findGreatVessels(SegmentedLumen segmented, const VoxelFill& fill, int threads,
                                       TracingProgress& progress, double blockMm = usualBlockMm);

}   // namespace angiopose::core