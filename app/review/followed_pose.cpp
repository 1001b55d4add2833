#include "app/review/followed_pose.h"

namespace angiopose::app {

const core::FollowedFrame* followedPoseShown(const core::View& view)
{
    const core::FollowedFrame* frame = core::findFrame(view.followed, view.frame);
    return frame && frame->tracked.cameraFromPatient.matrix() == view.cameraFromPatient.matrix() ? frame : nullptr;
}

}   // namespace angiopose::app
