#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/tree/vessel_curve.h"

namespace angiopose::core {

/// Whether a curve without branches is the rest of a cropped bulge rather than a vessel: it ends where the rim of the
/// grid cuts the lumen, and protrudes from its parent's wall by less than `minMm` or 1.5 of its own radius. For an
/// intact vessel end the ball at its tip counts; a cut end has none.
bool isRimStub(const VesselCurve& curve, const VesselCurve& parent, const VoxelMask& lumen, double minMm);

/// Whether a curve without parent is a remainder of the crop: it is cut off at both ends and shorter than `minMm`.
bool isRimCrumb(const VesselCurve& curve, const VoxelMask& lumen, double minMm);

}   // namespace angiopose::core
