#pragma once

#include "core/case/case.h"

namespace angiopose::app {

/// Returns the depth of the tree's centroid from the source in a view, mm; at least the smallest projectable depth.
double depthOfTreeMm(const core::View& view, const core::Vessels& vessels);

/// Returns whether the tree's coordinates are patient coordinates. A case may store an initial pose for a tree with
/// arbitrary axes; that pose counts only if it agrees with the C-arm angles, which refer to the patient.
bool isOrientationKnown(const core::View& view, const core::Vessels& vessels);

}   // namespace angiopose::app
