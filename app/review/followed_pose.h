#pragma once

#include "core/case/view.h"

namespace angiopose::app {

/// What following found in the shown frame, while the pose is that one: neither of a run nor by hand. Else null.
const core::FollowedFrame* followedPoseShown(const core::View& view);

}   // namespace angiopose::app
