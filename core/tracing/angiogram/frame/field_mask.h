#pragma once

#include "core/imaging/image2d.h"

namespace angiopose::core {

/// Where the detector was exposed: 255 inside shutter, image intensifier and drawn-in frame, 0 outside and on their
/// edges. Needs vessels dark, so that unexposed is dark; bright frames count as drawn in where they are of one value.
/// `widestVesselPx` keeps vessels that leave through the image edge inside the field. The field ends at the edge of the
/// header's shutter too (`Angiogram::shutter`, of the image's size or larger; empty: none).
Mask2d findField(const ImageF& vesselsDark, double widestVesselPx, const Mask2d& shutter = {});

}   // namespace angiopose::core