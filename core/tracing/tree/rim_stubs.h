#pragma once

#include "core/imaging/volume.h"
#include "core/tracing/tree/vessel_curve.h"

namespace angiopose::core {

/// Whether a curve without branches is what a crop leaves of a bulge rather than a vessel: it ends where the rim of the
/// grid cuts the lumen, and stands beyond its parent's wall by less than `minMm` or 1.5 of its own radius. A vessel's
/// end that is whole counts with the ball at its tip; one that is cut has none.
bool isRimStub(const VesselCurve& curve, const VesselCurve& parent, const VoxelMask& lumen, double minMm);

/// The same of a curve without parent: it is cut off at both ends and shorter than `minMm`.
bool isRimCrumb(const VesselCurve& curve, const VoxelMask& lumen, double minMm);

}   // namespace angiopose::core
