#pragma once

#include "core/imaging/angiogram.h"
#include "core/imaging/image2d.h"
#include "core/tracing/angiogram/frame/trace_options.h"

namespace angiopose::core {

/// Images that guide manual drawing on a frame: `LiveWire` follows the vesselness, and `addDrawnCurve` centers curves
/// on the opacity. Unlike tracing, computing them does not fail if the frame shows no vessels.
struct DrawingGuide {
    ImageF vesselness;   ///< 0…1
    ImageF opacity;   ///< darkening relative to the flattened background; vessels are positive
    Mask2d fieldMask;   ///< 0 in regions excluded from tracing: shutter, border, burned-in text
};

/// Computes the images; all are empty if the frame is empty or has non-finite values. For `shutter`, see `findField`.
DrawingGuide computeDrawingGuide(const ImageF& frame, Polarity polarity, const TraceOptions& options = {},
                                 const Mask2d& shutter = {});

}   // namespace angiopose::core
