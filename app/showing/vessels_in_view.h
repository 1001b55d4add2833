#pragma once

#include "core/case/case.h"

namespace angiopose::app {

/// How far from the source the tree's centroid lies in a view, mm; far enough to be projected.
double depthOfTreeMm(const core::View& view, const core::Vessels& vessels);

/// Whether the tree's coordinates are the patient's. A case brings its own start pose with whatever axes its tree has:
/// believed only while it agrees with the angles of the C-arm, which are the patient's.
bool isOrientationKnown(const core::View& view, const core::Vessels& vessels);

}   // namespace angiopose::app
