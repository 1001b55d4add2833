#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Mask of the exposed detector area: 255 inside shutter, image intensifier and drawn-in frame, 0 outside and on their
/// edges. Expects dark vessels, so unexposed means dark; bright frames count as drawn in if they have a single value.
/// `widestVesselPx` keeps vessels that leave through the image edge inside the field. The field also ends at the edge
/// of the header's shutter (`Angiogram::shutter`, of the image's size or larger; empty: none).
Mask2d findField(const ImageF& vesselsDark, double widestVesselPx, const Mask2d& shutter = {});

}   // namespace angiopose::core
