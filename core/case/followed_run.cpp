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

const FollowedFrame* deformationAt(const FollowedRun& run, const RigidTransform& cameraFromPatient)
{
    const std::vector<FollowedFrame>& frames = framesOf(run);
    const auto found = std::ranges::find_if(frames, [&](const FollowedFrame& each) {
        return each.deformed && each.tracked.cameraFromPatient.matrix() == cameraFromPatient.matrix();
    });
    return found == frames.end() ? nullptr : &*found;
}

bool isDeformedByItself(const FollowedFrame& frame)
{
    return frame.deformed && !frame.deformedAsInFrame;
}

std::shared_ptr<const DeformableResult> carriedDeformation(const FollowedFrame& from,
                                                           const RigidTransform& cameraFromPatient)
{
    auto carried = std::make_shared<DeformableResult>(*from.deformed);
    carried->cameraFromPatient =
        cameraFromPatient * from.tracked.cameraFromPatient.inverse() * carried->cameraFromPatient;
    carried->viewPoses = {carried->cameraFromPatient};
    return carried;
}

}   // namespace angiopose::core
