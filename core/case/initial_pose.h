#pragma once

#include "core/case/vessels.h"
#include "core/case/view.h"

namespace angiopose::core {

/// Returns the initial pose of the vessels in a view: the given pose, or else a pose computed from the angles of the
/// frame. The computed pose rotates about the isocenter if the view has one; otherwise it puts the tree's centroid on
/// the beam axis, in the object plane of the header or at the isocenter distance.
Result<RigidTransform> initialPoseOf(const View& view, const Vessels& vessels);

/// Whether the vessels of a view are at their initial pose, neither registered nor moved.
bool isAtInitialPose(const View& view, const Vessels& vessels);

/// Returns the view at another frame, with that frame's tracked pose if there is one. If the gantry rotated in between,
/// the poses rotate with it about the isocenter.
View withFrame(View view, int frame);

}   // namespace angiopose::core
