#include "core/workflow/follow_frames.h"

#include "core/case/known_bend.h"
#include "core/messages/says.h"
#include "core/registration/deformable/smooth_bends.h"
#include "core/registration/follow_run.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace angiopose::core {
namespace {

Status checkCase(const Case& theCase)
{
    if (!theCase.shown().angiogram || theCase.shown().angiogram->frameCount() < 2) {
        return Error(says::followOneFrame());
    }
    if (theCase.shown().target.centerline && !theCase.shown().target.editedFrame) {
        return Error(says::followGivenTarget());
    }
    if (!theCase.shown().angiogram->gantry.angleIncrementsDeg.empty()) {
        return Error(says::followGantryTurns());
    }
    return Done{};
}

/// Walks away from the first frame in one direction.
class Walk {
public:
    Walk(const Case& theCase, RunFollower follower)
        : case_(theCase), follower_(std::move(follower)), last_(theCase.shown().cameraFromPatient)
    {
        const auto start = traceHere();
        startsStill_ = !start || start.value().standsStill;
    }

    FollowedFrame step(int frame, const SearchObserver& observe)
    {
        FollowedFrame followed;
        followed.frame = frame;
        followed.tracked.cameraFromPatient = last_;
        case_.shown().frame = frame;
        const auto target = targetHere();
        const auto found = target ? follower_.next(target.value(), observe) : Result<TrackedVessels>(target.error());
        if (found) {
            followed.tracked = found.value().tracked;
            followed.bent = found.value().bent;
            last_ = followed.tracked.cameraFromPatient;
        } else {
            followed.problem = found.error().message;
        }
        return followed;
    }

private:
    Result<AngiogramTrace> traceHere() const
    {
        const View& view = case_.shown();
        return traceFrame(*view.angiogram, view.frame, traceOptionsOf(view));
    }

    /// Lines that stand still agree with a pose in every frame, those without contrast too: they are no target, unless
    /// the frame that following began with shows nothing else either, as a phantom's does.
    Result<Centerline2d> targetHere() const
    {
        if (const auto given = givenTargetOf(case_.shown())) {
            return *given;
        }
        const auto trace = traceHere();
        if (!trace) {
            return trace.error();
        }
        return trace.value().standsStill && !startsStill_ ? Result<Centerline2d>(Error(says::followStandsStill()))
                                                          : trace.value().centerline;
    }

    Case case_;
    RunFollower follower_;
    RigidTransform last_;
    bool startsStill_ = false;
};

/// Of one view: of several it is known in space, and one run does not tell how that goes on.
std::shared_ptr<const DeformableResult> bendToFollow(const Case& theCase)
{
    const auto bent = knownBend(theCase.shown(), theCase.vessels, theCase.shown().cameraFromPatient);
    return bent && bent->viewPoses.size() == 1 ? bent : nullptr;
}

FollowedFrame givenFrame(const Case& theCase)
{
    FollowedFrame given;
    given.frame = theCase.shown().frame;
    given.tracked.cameraFromPatient = theCase.shown().cameraFromPatient;
    given.tracked.isTrustworthy = true;
    given.tracked.score = 1.0;
    given.bent = bendToFollow(theCase);
    return given;
}

/// Each frame was bent by itself; in time they belong together.
void smoothBends(const VesselTree& tree, std::vector<FollowedFrame>& frames)
{
    std::vector<BendInTime> bends;
    for (const FollowedFrame& each : frames) {
        if (each.bent) {
            bends.push_back({each.frame, each.tracked.cameraFromPatient, each.bent});
        }
    }
    for (const BendInTime& smooth : smoothInTime(tree, bends)) {
        std::ranges::find(frames, smooth.frame, &FollowedFrame::frame)->bent = smooth.bent;
    }
}

/// Poses were found for bent vessels: frames that do not show them have them bent as in the nearest that does.
void carryBends(std::vector<FollowedFrame>& frames)
{
    const std::vector<FollowedFrame> found = frames;
    for (FollowedFrame& each : frames) {
        const FollowedFrame* nearest = nullptr;
        for (const FollowedFrame& other : found) {
            if (other.bent &&
                (!nearest || std::abs(other.frame - each.frame) < std::abs(nearest->frame - each.frame))) {
                nearest = &other;
            }
        }
        if (each.bent || !nearest || each.tracked.isTrustworthy) {
            continue;
        }
        each.bent = carriedBend(*nearest, each.tracked.cameraFromPatient);
        each.bentAsInFrame = nearest->frame;
    }
}

}   // namespace

Result<std::vector<FollowedFrame>> followFrames(const Case& theCase, const WorkObserver& observe)
{
    if (const Status status = checkCase(theCase); !status) {
        return status.error();
    }
    auto target = targetOf(theCase.shown());
    if (!target) {
        return target.error();
    }
    const auto input = registrationInputOf(theCase.shown(), theCase.vessels, std::move(target).value());
    if (!input) {
        return input.error();
    }
    const auto follower = RunFollower::from(input.value(), bendToFollow(theCase), theCase.options);
    if (!follower) {
        return follower.error();
    }
    const int count = theCase.shown().angiogram->frameCount();
    std::vector<FollowedFrame> frames{givenFrame(theCase)};
    Course course(observe);
    course.enter(0.0, 1.0, theCase.shownView);
    for (const int direction : {1, -1}) {
        Walk walk(theCase, follower.value());
        for (int frame = theCase.shown().frame + direction; frame >= 0 && frame < count && !course.isStopped();
             frame += direction) {
            const double done = static_cast<double>(frames.size()) / count;
            FollowedFrame followed = walk.step(frame, [&](double) { return course.tell("following", done); });
            if (course.isStopped()) {
                break;   // in the midst of this frame
            }
            frames.push_back(std::move(followed));
            course.tell("following", static_cast<double>(frames.size()) / count);
        }
    }
    std::ranges::sort(frames, {}, &FollowedFrame::frame);
    if (theCase.vessels.tree) {
        smoothBends(*theCase.vessels.tree, frames);
        carryBends(frames);
    }
    return frames;
}

RunPeriods periodsOf(const Case& theCase, const std::vector<FollowedFrame>& frames)
{
    const auto& run = theCase.shown().angiogram;
    if (!run || !theCase.vessels.tree || !(run->frameTimeMs > 1.0)) {   // 1 ms and less: not told
        return {};
    }
    std::vector<TimedPose> poses;
    for (const FollowedFrame& each : frames) {
        if (each.tracked.isTrustworthy) {
            poses.push_back({1e-3 * run->frameTimeMs * each.frame, each.tracked.cameraFromPatient});
        }
    }
    return findPeriods(poses, centroidInPatient(*theCase.vessels.tree));
}

}   // namespace angiopose::core