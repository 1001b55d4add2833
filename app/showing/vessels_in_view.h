#pragma once

#include "core/case/case.h"

namespace angiopose::app {

/// Depth of the tree's centroid from the source in a view, mm; at least the smallest projectable depth.
double depthOfTreeMm(const core::View& view, const core::Vessels& vessels);

/// Whether the tree's coordinates are patient coordinates. A case may bring an initial pose for a tree with arbitrary
/// axes; it counts only while it agrees with the C-arm angles, which refer to the patient.
bool isOrientationKnown(const core::View& view, const core::Vessels& vessels);

}   // namespace angiopose::app
