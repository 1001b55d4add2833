#include "core/case/tracked_run.h"

#include <algorithm>
#include <utility>

namespace angiopose::core {

TrackedRun makeTrackedRun(int frame, std::vector<TrackedRunFrame> frames)
{
    return {std::make_shared<const std::vector<TrackedRunFrame>>(std::move(frames)), frame, {}};
}

const std::vector<TrackedRunFrame>& framesOf(const TrackedRun& run)
{
    static const std::vector<TrackedRunFrame> none;
    return run.frames ? *run.frames : none;
}

const TrackedRunFrame* findFrame(const TrackedRun& run, int frame)
{
    const std::vector<TrackedRunFrame>& frames = framesOf(run);
    const auto found = std::ranges::find(frames, frame, &TrackedRunFrame::frame);
    return found == frames.end() ? nullptr : &*found;
}

const TrackedRunFrame* findDeformedFrame(const TrackedRun& run, const RigidTransform& cameraFromPatient)
{
    const std::vector<TrackedRunFrame>& frames = framesOf(run);
    const auto found = std::ranges::find_if(frames, [&](const TrackedRunFrame& each) {
        return each.deformed && each.tracked.cameraFromPatient.matrix() == cameraFromPatient.matrix();
    });
    return found == frames.end() ? nullptr : &*found;
}

bool hasOwnDeformation(const TrackedRunFrame& frame)
{
    return frame.deformed && !frame.deformationSourceFrame;
}

std::shared_ptr<const DeformableResult> transferDeformation(const TrackedRunFrame& from,
                                                            const RigidTransform& cameraFromPatient)
{
    auto carried = std::make_shared<DeformableResult>(*from.deformed);
    carried->cameraFromPatient =
        cameraFromPatient * from.tracked.cameraFromPatient.inverse() * carried->cameraFromPatient;
    carried->viewPoses = {carried->cameraFromPatient};
    return carried;
}

}   // namespace angiopose::core
