#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/volume/touching_vessels.h"
#include "core/tracing/volume/trace_vessels.h"
#include "core/tracing/volume/tracing_progress.h"

namespace core {

/// Takes out of a mask what is reached from a place to avoid on a wider way than from a seed, so that vessels that hang
/// together part at their narrowest place (flooding of the distance map from markers, Meyer 1994). What lies beyond
/// necks (see `voxelsBeyondNecks`) and, where `fill` is given, vessels of other blood are avoided as well. Places that
/// lie in nothing are ignored. Incomplete when stopped.
void splitBySeeds(VoxelMask& mask, const VesselTracingOptions& options, const VoxelFill& fill,
                  TracingProgress& progress);

}   // namespace core
