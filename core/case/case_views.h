#pragma once

#include "core/case/case.h"

#include <cstddef>
#include <vector>

namespace angiopose::core {

/// Returns the case with view `index` shown and stored in the case itself, because the shown view can be edited.
Case withShownView(Case session, std::size_t index);

/// Returns the case without view `index`. If that view is shown, the next view with an image is shown instead; if there
/// is no such view, the case is returned unchanged.
Case withoutView(Case session, std::size_t index);

/// Returns the indices of the views that are registered together: the shown view (with or without an image) first, then
/// all others with an image.
std::vector<std::size_t> registeredViews(const Case& session);

/// Returns the views at these indices, in the same order.
std::vector<View> viewsAt(const Case& session, const std::vector<std::size_t>& viewIndices);

/// Returns the pose in view `viewIndex` after the vessels move to `cameraFromPatient` in the shown view, with the
/// relative camera positions fixed.
RigidTransform poseAfterMotion(const Case& session, std::size_t viewIndex, const RigidTransform& cameraFromPatient);

/// Returns the views after the vessels move to `cameraFromPatient` in the shown view. The current relative camera
/// positions are kept, registration results are discarded, and views without an image stay unchanged.
std::vector<View> viewsAfterMotion(const Case& session, const RigidTransform& cameraFromPatient);

/// Returns the views with each registered view at its own initial pose; views without an initial pose stay unchanged.
std::vector<View> viewsAtInitialPose(const Case& session);

}   // namespace angiopose::core
