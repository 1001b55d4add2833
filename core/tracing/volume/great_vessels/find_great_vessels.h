#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/great_vessels/coarse_blood.h"
#include "core/tracing/volume/great_vessels/great_vessels.h"
#include "core/tracing/volume/lumen/segment_lumen.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <vector>

namespace angiopose::core {

/// A lumen with all that belongs to it, and the great vessels in it.
struct LumenWithGreatVessels {
    VoxelMask lumen;
    std::vector<GreatVessel> great;
};

/// Where there are stents, great vessels are sought with and without what lies beside the wires: walks end where a
/// vessel is much wider from one section to the next, be it by what wires hide or where a stent widens it. Those whose
/// first is of greater worth are taken. Incomplete when stopped.
LumenWithGreatVessels findGreatVessels(SegmentedLumen segmented, const VoxelFill& fill, int threads,
                                       TracingProgress& progress, double blockMm = usualBlockMm);

}   // namespace angiopose::core