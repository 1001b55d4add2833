#pragma once

#include "core/case/view.h"

namespace angiopose::app {

/// Returns the tracking result of the shown frame if the current pose comes from it rather than from a registration or
/// a manual edit; otherwise null.
inline const core::TrackedRunFrame* shownTrackedPose(const core::View& view)
{
    const core::TrackedRunFrame* frame = core::findFrame(view.followed, view.frame);
    return frame && frame->tracked.cameraFromPatient.matrix() == view.cameraFromPatient.matrix() ? frame : nullptr;
}

}   // namespace angiopose::app
