#pragma once

#include "core/support/result.h"
#include "core/tracing/volume/voxels/traced_vessels.h"
#include "core/tracing/volume/voxels/tracing_options.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

namespace angiopose::core {

/// Traces thin vessels of a scan from seeds through tube-like structures (ALGORITHMS §9.13): coronary arteries next to
/// opacified chambers, hepatic arteries next to the portal vein. Tracing ends at chambers, organs and vessels wider
/// than a centimeter. Ignores the options `minBranchRadiusMm` and `threshold` and points to avoid. Fails without a
/// seed, for seeds outside the scan or not in a bright structure, and if no branch is long enough; returns as stopped
/// if the observer requests it.
Result<TracedVessels> traceTubes(const Volume& volume, const VesselTracingOptions& options,
                                 const TracingObserver& observe = {});

}   // namespace angiopose::core
