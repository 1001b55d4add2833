#pragma once

#include "core/imaging/image2d.h"
#include "core/tracing/angiogram/curves/skeleton_graph.h"
#include "core/tracing/angiogram/frame/trace_options.h"

namespace angiopose::core {

/// Builds the graph of a vessel mask and keeps only vessel-like parts: no edges along the edge of the field, no short
/// or weak side branches, no short or weak components.
SkeletonGraph extractVesselBranches(const Mask2d& vessels, const ImageF& evidence, const ImageF& opacity,
                                    const Mask2d& field, const TraceOptions& options);

/// Variant of `extractVesselBranches` for manually drawn masks, which judges edges by length alone.
SkeletonGraph extractDrawnBranches(const Mask2d& vessels, const TraceOptions& options);

}   // namespace angiopose::core
