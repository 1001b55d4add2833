#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/tracing/volume/voxels/traced_vessels.h"
#include "core/tracing/volume/voxels/tracing_options.h"
#include "core/tracing/volume/voxels/tracing_progress.h"

#include <vector>

namespace angiopose::core {

/// Contrast-filled vessels of a CT angiogram: threshold or seeded growth, bone and table left out, thinning, a tree of
/// smooth centrelines with radii. Without seeds the tree is that of the vessel most like an aorta (see `Trunk::worth`),
/// else of the largest piece; a warning says which. Fails on an empty or flat volume, seeds outside the lumen, when
/// nothing is like a vessel (the axes of that piece hold no blood); with `tubesOnly` see `traceTubes`; ends as
/// stopped when the observer says so, then nothing is kept. Needs at most twice the volume's own memory besides it.
Result<TracedVessels> traceVessels(const Volume& volume, const VesselTracingOptions& options = {},
                                   const TracingObserver& observe = {});

/// A mask of vessels, taken as it is: all its pieces, or those that hold the seeds. Gaps over which it is clear that a
/// vessel goes on are closed.
Result<TracedVessels> traceMask(const VoxelMask& mask, const VesselTracingOptions& options = {},
                                const TracingObserver& observe = {});

/// The vessels of a label image that carry one of `labels`; none given: any label.
Result<TracedVessels> traceLabels(const LabelVolume& image, const std::vector<int>& labels,
                                  const VesselTracingOptions& options = {}, const TracingObserver& observe = {});

}   // namespace angiopose::core