#pragma once

#include "core/imaging/angiogram.h"
#include "core/imaging/image2d.h"
#include "core/tracing/angiogram/frame/trace_options.h"

namespace angiopose::core {

/// What a hand that draws curves on a frame leans on: `LiveWire` follows the vesselness, `withDrawn` centres on the
/// opacity. Unlike tracing it needs no vessel to be found.
struct DrawingGround {
    ImageF vesselness;   ///< 0…1
    ImageF opacity;   ///< background flattened, vessels positive
    Mask2d fieldMask;   ///< 0 where nothing is traced: shutter, border, burned-in text
};

/// Everything is empty for an empty frame and one with values that are not finite. `shutter` as for `findField`.
DrawingGround drawingGround(const ImageF& frame, Polarity polarity, const TraceOptions& options = {},
                            const Mask2d& shutter = {});

}   // namespace angiopose::core