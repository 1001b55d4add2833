#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Returns the mask of the exposed detector area: 255 inside shutter, image intensifier circle and drawn frame, 0
/// outside and on their edges. Expects dark vessels, so unexposed areas are dark; bright ones are recognized if they
/// have one value. `widestVesselPx` keeps vessels that leave through the image edge inside the field. The field also
/// ends at the edge of the header's shutter (`Angiogram::shutter`, at least as large as the image; empty if none).
Mask2d findField(const ImageF& vesselsDark, double widestVesselPx, const Mask2d& shutter = {});

}   // namespace angiopose::core
