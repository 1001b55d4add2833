#pragma once

#include "core/case/view.h"

namespace angiopose::app {

/// Returns the tracking result of the shown frame if the current pose comes from it, and not from a registration or a
/// manual edit; otherwise null.
const core::TrackedRunFrame* shownTrackedPose(const core::View& view);

}   // namespace angiopose::app
