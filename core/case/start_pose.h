#pragma once

#include "core/case/vessels.h"
#include "core/case/view.h"

namespace angiopose::core {

/// The start pose of the vessels in a view: given, or from the angles of the frame, about the isocentre where the view
/// has it, else with the tree's centroid on the beam's axis, in the object plane of the header or at the isocenter.
Result<RigidTransform> startPoseOf(const View& view, const Vessels& vessels);

/// Whether the vessels of a view are where they start: neither registered nor moved.
bool isAtStart(const View& view, const Vessels& vessels);

/// The view at another frame, at its own pose where following found one. Where the gantry turned in between, the poses
/// turn with it about the isocentre.
View withFrame(View view, int frame);

}   // namespace angiopose::core
