#pragma once

#include "core/imaging/angiogram.h"
#include "core/imaging/image2d.h"
#include "core/tracing/angiogram/frame/trace_options.h"

namespace angiopose::core {

/// Images that guide manual drawing of curves on a frame: `LiveWire` follows the vesselness, `withDrawn` centers on the
/// opacity. Unlike tracing, this does not require that a vessel is found.
struct DrawingGround {
    ImageF vesselness;   ///< 0…1
    ImageF opacity;   ///< flattened background; vessels positive
    Mask2d fieldMask;   ///< 0 in regions excluded from tracing: shutter, border, burned-in text
};

/// All images are empty for an empty frame or one with non-finite values. `shutter` as for `findField`.
DrawingGround drawingGround(const ImageF& frame, Polarity polarity, const TraceOptions& options = {},
                            const Mask2d& shutter = {});

}   // namespace angiopose::core