#pragma once

#include "core/case/vessels.h"
#include "core/case/view.h"

namespace angiopose::core {

/// The start pose of the vessels in a view: given, or from the angles of the frame with the isocentre where the view
/// has it, else in the tree's centroid.
Result<RigidTransform> startPoseOf(const View& view, const Vessels& vessels);

/// Whether the vessels of a view are where they start: neither registered nor moved.
bool isAtStart(const View& view, const Vessels& vessels);

/// The view at another frame, at its own pose where following found one. Where the gantry turned in between, the poses
/// turn with it about the isocentre.
View withFrame(View view, const Vessels& vessels, int frame);

/// From the camera of one view to that of another: distances and angles of both gantries about one isocentre, whatever
/// coordinates the vessels have; where a view lacks them, what leads from start pose to start pose (ALGORITHMS §5.5).
/// Fails where a view has neither.
Result<RigidTransform> viewFromView(const View& first, const View& view, const Vessels& vessels);

}   // namespace angiopose::core
