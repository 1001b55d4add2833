#pragma once

#include "core/case/view.h"

namespace angiopose::app {

/// Tracking result of the shown frame, if the current pose is the tracked one, and not that of a registration or a
/// manual edit; else null.
const core::FollowedFrame* followedPoseShown(const core::View& view);

}   // namespace angiopose::app
