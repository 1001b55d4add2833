#pragma once

#include "core/case/case.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// The case that shows view `index`. What is shown may be edited, so that it stands in this case from now on.
Case showingView(Case session, std::size_t index);

/// The case without view `index`. In place of the shown view the next one with an image is shown; where there is none,
/// the case stays as it is.
Case withoutView(Case session, std::size_t index);

/// Places in `views` of those that have an image, the shown one (with or without) first: the views that are registered
/// together.
std::vector<std::size_t> registeredViews(const Case& session);

/// These views, in the same order.
std::vector<View> viewsAt(const Case& session, const std::vector<std::size_t>& places);

/// The pose in view `place` when the vessels are moved to `cameraFromPatient` in the shown one and the cameras keep
/// their places to each other.
RigidTransform poseMovedAlong(const Case& session, std::size_t place, const RigidTransform& cameraFromPatient);

/// The views after the vessels were moved to `cameraFromPatient` in the shown one: the cameras keep their places to
/// each other, as they are now, and results of runs hold no longer. Views without an image stay as they are.
std::vector<View> movedAlong(const Case& session, const RigidTransform& cameraFromPatient);

/// The views, each at its own start pose where it has one.
std::vector<View> atStart(const Case& session);

}   // namespace angiopose::core
