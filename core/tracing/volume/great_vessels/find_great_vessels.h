#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/great_vessels/block_opacification.h"
#include "core/tracing/volume/great_vessels/great_vessels.h"
#include "core/tracing/volume/lumen/segment_lumen.h"
#include "core/tracing/volume/voxels/touching_vessels.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <vector>

namespace angiopose::core {

/// Complete lumen and its great vessels.
struct LumenWithGreatVessels {
    VoxelMask lumen;
    std::vector<GreatVessel> greatVessels;
};

/// Finds the great vessels. Stents hide or widen sections abruptly and stop the tracking; scans with stents are
/// therefore searched with and without the lumen beside the struts, and the result with the higher-scoring first vessel
/// is kept. Incomplete when stopped.
LumenWithGreatVessels findGreatVessels(SegmentedLumen segmented, const VoxelOpacification& opacification, int threads,
                                       TracingProgress& progress, double blockMm = defaultBlockMm);

}   // namespace angiopose::core
