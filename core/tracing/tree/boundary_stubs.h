#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/tree/vessel_curve.h"

namespace angiopose::core {

/// Returns whether a curve without branches is the remainder of a cropped bulge rather than a vessel: it ends where the
/// grid boundary cuts the lumen, and protrudes from its parent's wall by less than `minMm` or 1.5 times its own radius.
/// Unlike at an intact end, the radius at the tip does not count toward the length.
bool isBoundaryStub(const VesselCurve& curve, const VesselCurve& parent, const VoxelMask& lumen, double minMm);

/// Returns whether a curve without a parent is a cropping remnant: cut off at both ends and shorter than `minMm`.
bool isBoundaryFragment(const VesselCurve& curve, const VoxelMask& lumen, double minMm);

}   // namespace angiopose::core
