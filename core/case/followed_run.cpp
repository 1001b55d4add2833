#include "core/case/followed_run.h"

#include <algorithm>
#include <utility>

namespace angiopose::core {

FollowedRun followedFrom(int frame, std::vector<FollowedFrame> frames)
{
    return {std::make_shared<const std::vector<FollowedFrame>>(std::move(frames)), frame, {}};
}

const std::vector<FollowedFrame>& framesOf(const FollowedRun& run)
{
    static const std::vector<FollowedFrame> none;
    return run.frames ? *run.frames : none;
}

const FollowedFrame* findFrame(const FollowedRun& run, int frame)
{
    const std::vector<FollowedFrame>& frames = framesOf(run);
    const auto found = std::ranges::find(frames, frame, &FollowedFrame::frame);
    return found == frames.end() ? nullptr : &*found;
}

const FollowedFrame* bendAt(const FollowedRun& run, const RigidTransform& cameraFromPatient)
{
    const std::vector<FollowedFrame>& frames = framesOf(run);
    const auto found = std::ranges::find_if(frames, [&](const FollowedFrame& each) {
        return each.bent && each.tracked.cameraFromPatient.matrix() == cameraFromPatient.matrix();
    });
    return found == frames.end() ? nullptr : &*found;
}

bool isBentByItself(const FollowedFrame& frame)
{
    return frame.bent && !frame.bentAsInFrame;
}

std::shared_ptr<const DeformableResult> carriedBend(const FollowedFrame& from, const RigidTransform& cameraFromPatient)
{
    auto carried = std::make_shared<DeformableResult>(*from.bent);
    carried->cameraFromPatient =
        cameraFromPatient * from.tracked.cameraFromPatient.inverse() * carried->cameraFromPatient;
    carried->viewPoses = {carried->cameraFromPatient};
    return carried;
}

}   // namespace angiopose::core
