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

/// Result of tracing one frame, with intermediate results.
struct AngiogramTrace {
    Centerline2d centerline;
    std::vector<int> suspectCurves;   ///< ids of curves that may be catheters, wires or bone edges
    ImageF vesselness;   ///< 0…1
    double clutter = 0.0;   ///< vesselness of noise and background; 0 for drawn masks
    Mask2d vesselMask;   ///< pixels between the walls of the curves, at half height of the edges
    Mask2d fieldMask;   ///< exposed area inside shutter and border, without burned-in text
    bool isStationary = false;   ///< whether most lines are stationary, so that no contrast agent moves in this run
    Messages warnings;   ///< for example that no contrast agent arrives in this run
};

/// Traces the vessels of one frame: vesselness → threshold above the frame's own clutter → thinning → ordered, smoothed
/// curves with width (ALGORITHMS §8). A two-level mask (see `vesselMaskFromDrawing`) is used unchanged. Fails if the
/// options exclude all vessels (radii in the wrong order, …), or if the frame is empty, uniform, not finite, or shows
/// nothing vessel-like. Traces nothing on or beyond the edge of the `shutter` (see `findField`).
Result<AngiogramTrace> traceAngiogram(const ImageF& frame, Polarity polarity, const TraceOptions& options = {},
                                      const Mask2d& shutter = {});

/// Traces one frame of a run, with less noise where the run is static (see `denoiseFrame`). Also marks as suspect the
/// curves that the first frame already shows (`fractionsSeenBefore`; warns if nearly all) and those that are stationary
/// while vessels move (`findStationaryCurves`).
Result<AngiogramTrace> traceFrame(const Angiogram& run, int frame, const TraceOptions& options = {});

/// Traces the curves of a drawn mask (e.g. a PNG) by thinning and ordering alone.
Result<Centerline2d> traceMask(const Mask2d& mask, const TraceOptions& options = {});

}   // namespace angiopose::core
