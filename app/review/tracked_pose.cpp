#include "app/review/tracked_pose.h"

namespace angiopose::app {

const core::TrackedRunFrame* shownTrackedPose(const core::View& view)
{
    const core::TrackedRunFrame* frame = core::findFrame(view.followed, view.frame);
    return frame && frame->tracked.cameraFromPatient.matrix() == view.cameraFromPatient.matrix() ? frame : nullptr;
}

}   // namespace angiopose::app
