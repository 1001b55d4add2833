#pragma once

#include "core/imaging/angiogram.h"
#include "core/imaging/image2d.h"
#include "core/support/message.h"
#include "core/support/result.h"
#include "core/tracing/angiogram/frame/trace_options.h"
#include "core/vessel/centerline2d.h"

#include <string>
#include <vector>

namespace angiopose::core {

/// What tracing found in one frame, with what it saw on the way.
struct AngiogramTrace {
    Centerline2d centerline;
    std::vector<int> suspectCurves;   ///< ids of curves that may be catheters, wires or edges of bones
    ImageF vesselness;   ///< 0…1
    double clutter = 0.0;   ///< the vesselness that noise and background reach; 0 of what is drawn
    Mask2d vesselMask;   ///< between the walls of the curves: where the edges have half of their height
    Mask2d fieldMask;   ///< where the image is exposed: inside shutter and border, without burned-in text
    bool standsStill = false;   ///< little but lines that stand still through the run: no contrast agent moves here
    Messages warnings;   ///< that no contrast medium comes in this run
};

/// Vesselness → threshold above the frame's own clutter → thinning → ordered, smoothed curves with width (ALGORITHMS
/// §8). A mask of two levels (see `drawnMask`) is taken as it is drawn. Fails when the options are of no vessel
/// (radii the wrong way round, …), or the frame is empty, flat, not finite, or shows nothing vessel-like. Nothing is
/// traced on or beyond the edge of the `shutter` (see `findField`).
Result<AngiogramTrace> traceAngiogram(const ImageF& frame, Polarity polarity, const TraceOptions& options = {},
                                      const Mask2d& shutter = {});

/// The same for one frame of a run, with less noise where the run stands still (see `steadyFrame`). Curves that the
/// first frame shows already are suspects too, and where it shows nearly all of them a warning says so (`seenBefore`);
/// so are those that stand still through the run while vessels do not (`stillCurves`).
Result<AngiogramTrace> traceFrame(const Angiogram& run, int frame, const TraceOptions& options = {});

/// Curves of a drawn mask (e.g. a PNG): thinning and ordering only.
Result<Centerline2d> traceMask(const Mask2d& mask, const TraceOptions& options = {});

}   // namespace angiopose::core