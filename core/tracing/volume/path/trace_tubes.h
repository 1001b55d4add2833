#pragma once

#include "core/support/result.h"
#include "core/tracing/volume/voxels/traced_vessels.h"
#include "core/tracing/volume/voxels/tracing_options.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

namespace angiopose::core {

/// Thin vessels of a scan, reached from seeds through what is like a tube (ALGORITHMS §9.13): coronary arteries beside
/// filled chambers, hepatic arteries beside the portal vein. Chambers, organs and vessels wider than a centimetre end
/// them. `minBranchRadiusMm`, `threshold` and places to avoid do not count. Fails without a seed, for seeds outside the
/// scan or in nothing bright, and where nothing long enough was found; ends as stopped when the observer says so.
Result<TracedVessels> traceTubes(const Volume& volume, const VesselTracingOptions& options,
                                 const TracingObserver& observe = {});

}   // namespace angiopose::core
