#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/tracing/volume/voxels/traced_vessels.h"
#include "core/tracing/volume/voxels/tracing_options.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <vector>

namespace angiopose::core {

/// Traces the opacified vessels of a CT angiogram: threshold or seeded growth, removal of bone and table, thinning,
/// tree of smooth centerlines with radii. Without seeds, traces the vessel most like an aorta (see `Trunk::score`), or
/// else the largest connected component; a warning states which. Fails for an empty or uniform volume, for seeds
/// outside the lumen, and if nothing looks like a vessel (the centerlines of that component are not opacified); for
/// `tubesOnly`, see `traceTubes`. Returns as stopped, without a result, if the observer requests it. Needs up to twice
/// the memory of the volume in addition.
Result<TracedVessels> traceVessels(const Volume& volume, const VesselTracingOptions& options = {},
                                   const TracingObserver& observe = {});

/// Traces a vessel mask without segmentation: all its connected components, or those that contain the seeds. Gaps
/// across which a vessel clearly continues are closed.
Result<TracedVessels> traceMask(const VoxelMask& mask, const VesselTracingOptions& options = {},
                                const TracingObserver& observe = {});

/// Traces the vessels of a label image that have one of `labels`, or any label if `labels` is empty.
Result<TracedVessels> traceLabels(const LabelVolume& image, const std::vector<int>& labels,
                                  const VesselTracingOptions& options = {}, const TracingObserver& observe = {});

}   // namespace angiopose::core
