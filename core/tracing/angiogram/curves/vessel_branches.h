#pragma once

#include "core/imaging/image2d.h"
#include "core/tracing/angiogram/curves/skeleton_graph.h"
#include "core/tracing/angiogram/frame/trace_options.h"

namespace angiopose::core {

/// The graph of a vessel mask with only what looks like vessels: no stretches along the rim of the field, no short or
/// weak side branches, no short or weak pieces.
SkeletonGraph vesselBranches(const Mask2d& vessels, const ImageF& evidence, const ImageF& opacity, const Mask2d& field,
                             const TraceOptions& options);

/// The same by length alone, for masks that somebody drew.
SkeletonGraph drawnBranches(const Mask2d& vessels, const TraceOptions& options);

}   // namespace angiopose::core